using System.Collections;
using NUnit.Framework;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Counters of the system in the profiler, read as a user's own overlay would.</summary>
    public sealed class ProfilerCounterTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator Counters_FollowTheCrowd([Values(1, 7)] int insects)
        {
            for (int k = 0; k < insects; k++)
                Hatch();
            Time.captureDeltaTime = Time.fixedDeltaTime;
            yield return Frames(10);
            using (ProfilerRecorder count = Counter("Alate Insects"), steps = Counter("Alate Steps"), resets = Counter("Alate Resets"))
            {
                yield return Frames(3);

                Assert.That(count.Valid && steps.Valid && resets.Valid, Is.True);
                Assert.That(count.LastValue, Is.EqualTo(insects));
                Assert.That(steps.LastValue, Is.EqualTo(1), "one step job a frame of one fixed step, however many insects");
                Assert.That(resets.LastValue, Is.EqualTo(WingSystem.ResetCount));

                Time.timeScale = 0f;
                yield return Frames(3);
                Assert.That(count.LastValue, Is.EqualTo(insects));
                Assert.That(steps.LastValue, Is.Zero, "nothing is stepped while time stands still");
            }
        }

        [UnityTest]
        public IEnumerator Counters_AreZeroWhenTheLastInsectIsGone()
        {
            InsectWings insect = Hatch();
            yield return Frames(5);
            using (ProfilerRecorder count = Counter("Alate Insects"), steps = Counter("Alate Steps"), resets = Counter("Alate Resets"))
            {
                SystemCounter.resets.Set(7);
                SystemCounter.steps.Set(7);
                Object.DestroyImmediate(insect.gameObject);
                yield return Frames(4);
                Assert.That((count.LastValue, steps.LastValue, resets.LastValue), Is.EqualTo((0, 0, 0)));
            }
        }

        private static ProfilerRecorder Counter(string name) => ProfilerRecorder.StartNew(ProfilerCategory.Scripts, name);
    }
}
