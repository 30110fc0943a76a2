using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    public sealed class FlightLimitsLaws
    {
        private static readonly FlightLimits s_Limits = new FlightLimits(1.3f, -0.3f, 0.25f, 2.5f);

        // 0.2 s at its speed until it answers, then evenly braked: v²/2a.
        [Test]
        public void StoppingDistance_IsFlownInItsTime([Values(0.1f, 0.5f, 1.3f)] float speed)
        {
            double way = 0.2 * speed, v = speed;
            for (; v > 0; v -= 2.5 * 1e-5)
                way += v * 1e-5;
            Assert.That(s_Limits.StoppingDistance(speed), Is.EqualTo(way).Within(1e-4));
            Assert.That(s_Limits.StoppingDistance(-speed), Is.EqualTo(s_Limits.StoppingDistance(speed)));
        }

        [Test]
        public void SpeedToStopWithin_IsTheInverseOfTheStoppingDistance([Values(0.001f, 0.05f, 0.6f, 4f)] float distance)
        {
            Assert.That(s_Limits.StoppingDistance(s_Limits.SpeedToStopWithin(distance)),
                Is.EqualTo(distance).Within(1e-5f * (1f + distance)));
        }

        [Test]
        public void WithoutAnyWay_ThereIsNoSpeed([Values(0f, -0.1f, -9f)] float distance) =>
            Assert.That(s_Limits.SpeedToStopWithin(distance), Is.Zero);

        [Test]
        public void Limits_AreThoseThatWereGiven()
        {
            Assert.That(new float4(s_Limits.TopSpeed, s_Limits.LeastClimb, s_Limits.MostClimb, s_Limits.Acceleration),
                Is.EqualTo(new float4(1.3f, -0.3f, 0.25f, 2.5f)));
        }
    }
}
