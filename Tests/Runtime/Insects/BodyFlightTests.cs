using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Commands that the wings of a body take from its flight.</summary>
    public sealed class BodyFlightTests
    {
        [Test]
        public void ABodyThatStandsOnEnd_HasAPitchOfARightAngle_WhicheverWayIsUp()
        {
            // Unit vectors that are rounded may be a little longer than one.
            var random = new Random(7);
            for (int k = 0; k < 500; k++)
            {
                float3 up = random.NextFloat3Direction();
                var flight = new BodyFlight { forward = up, gravity = -9.81f * up };
                Assert.That(flight.Pitch, Is.EqualTo(0.5f * math.PI).Within(1e-3f), $"up is {up}");
                flight.forward = -up;
                Assert.That(flight.Pitch, Is.EqualTo(-0.5f * math.PI).Within(1e-3f), $"up is {up}");
            }
        }

        [Test]
        public void WithoutGravity_NothingTellsThePitch() =>
            Assert.That(new BodyFlight { forward = new float3(0f, 1f, 0f) }.Pitch, Is.Zero);
    }
}
