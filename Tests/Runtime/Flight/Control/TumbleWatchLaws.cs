using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Tumbles as a watch tells them: when, how long, how far.</summary>
    public sealed class TumbleWatchLaws
    {
        private const float k_Step = 0.02f;

        // Tumbles in steps 3 to 5 and from step 8 on, counted from 0; a step of 0.1 m to the right, then up.
        [Test]
        public void ATumble_LastsFromItsFirstStepToItsEnd_AndIsAsFarAsTheWayBetween()
        {
            var watch = new TumbleWatch();
            for (int step = 0; step < 11; step++)
            {
                bool tumbles = step >= 3 && step <= 5 || step >= 8;
                float3 moved = step < 5 ? new float3(0.1f, 0f, 0f) : new float3(0f, 0.1f, 0f);
                bool changes = watch.Step(tumbles, moved, (step + 1) * k_Step, k_Step);
                Assert.That(changes, Is.EqualTo(step == 3 || step == 6 || step == 8), $"step {step}");
                Assert.That(watch.IsTumbling, Is.EqualTo(tumbles));
                Assert.That(watch.Count, Is.EqualTo(step < 3 ? 0 : step < 8 ? 1 : 2));
                if (step == 6 || step == 7)
                {
                    Assert.That(watch.Last.time, Is.EqualTo(4 * k_Step).Within(1e-6));
                    Assert.That(watch.Last.seconds, Is.EqualTo(3 * k_Step).Within(1e-6f));
                    Assert.That(watch.Last.distance, Is.EqualTo(math.length(new float2(0.1f, 0.2f))).Within(1e-6f));
                }
            }

            Assert.That(watch.Last.time, Is.EqualTo(9 * k_Step).Within(1e-6));
            Assert.That(watch.Last.seconds, Is.EqualTo(2 * k_Step).Within(1e-6f), "it lasts");
        }
    }
}
