using System;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>A trim: the air that it keeps, and the motion of its bob by differences.</summary>
    public sealed class TrimStateLaws
    {
        [Test]
        public void ATrim_KeepsTheAirOfItsWake_InPointsAndCopies()
        {
            TrimState state = TrimLaws.State(7);
            for (int pair = 0; pair < state.inflow.Length; pair++)
            {
                state.inflow[pair] = new WingInflow
                {
                    mean = pair + 1f,
                    cosine1 = 2f,
                    sine1 = 3f,
                    cosine2 = 4f,
                    sine2 = new float3(5f, 6f, 7f),
                };
            }

            float[] point = new float[TrimPoint.Floats];
            state.Write(point, 11f);
            Assert.That(TrimState.Read(point, 11f).Inflow, Is.EqualTo(state.Inflow));
            Assert.That(state.Copy().Inflow, Is.EqualTo(state.Inflow));
        }

        // By differences: the velocity is the rate of the place, the pitch that of the bob.
        [Test]
        public void PlaceAndRotation_AreThoseOfTheBob([Values(0.0, 0.3, 1.8)] double beats)
        {
            TrimState state = TrimLaws.State(5);
            const double step = 1e-4;
            const float period = 0.09f;
            float3 rate = (state.PlaceAt(beats + step, period) - state.PlaceAt(beats - step, period)) / (float)(2 * step * period);
            double turn = 2 * Math.PI * beats, up = 0, ahead = 0, pitch = -state.Pitch;
            for (int k = 0; k < TrimPoint.Harmonics; k++)
            {
                double cos = Math.Cos((k + 1) * turn), sin = Math.Sin((k + 1) * turn);
                up += state.bob[2 * k] * cos + state.bob[2 * k + 1] * sin;
                ahead += state.bob[2 * (TrimPoint.Harmonics + k)] * cos + state.bob[2 * (TrimPoint.Harmonics + k) + 1] * sin;
                pitch += state.bob[2 * (2 * TrimPoint.Harmonics + k)] * cos + state.bob[2 * (2 * TrimPoint.Harmonics + k) + 1] * sin;
            }

            Assert.That(math.distance(rate, new float3(0f, (float)up, (float)ahead)), Is.LessThan(1e-2f));
            Assert.That(math.distance(math.rotate(state.RotationAt(beats), new float3(0f, 0f, 1f)),
                new float3(0f, -(float)Math.Sin(pitch), (float)Math.Cos(pitch))), Is.LessThan(1e-5f));
        }
    }
}
