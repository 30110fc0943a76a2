using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Beginnings of free flights: in the middle of a beat, or settled.</summary>
    public sealed class FlightStartTests
    {
        [TestCase(0f, 0.3f)]
        [TestCase(120f, -1f)]
        [TestCase(300f, 2f)]
        public void AFlight_BeginsAtThePhaseAndTheHeadingThatItIsGiven(float phase, float heading)
        {
            using var insect = new FlyingInsect("monarch");
            var start = new FlightStart { phase = phase, heading = heading, condition = new FlightCondition(0.65f, 0f) };
            using var flight = new FreeFlight(insect.Model, insect.Table, start);
            foreach (WingHandle wing in flight.Wings)
                Assert.That(math.degrees(flight.World.Read(wing).Phase), Is.EqualTo(phase).Within(0.5f), "degrees");

            float3 nose = math.rotate(flight.Rotation, new float3(0f, 0f, 1f));
            Assert.That(math.cos(math.atan2(nose.x, nose.z) - heading), Is.EqualTo(1f).Within(1e-3f));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
        }
    }
}
