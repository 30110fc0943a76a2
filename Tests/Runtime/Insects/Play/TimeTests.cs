using System;
using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Time that stands, jumps, or is counted otherwise.</summary>
    public sealed class TimeTests : FlockFixture
    {
        private const float k_RestingFrequency = 0.8f * 11f;
        private float m_FixedDeltaTime;

        [SetUp]
        public void NoteTheFixedStep() => m_FixedDeltaTime = Time.fixedDeltaTime;

        [TearDown]
        public void RestoreTheFixedStep() => Time.fixedDeltaTime = m_FixedDeltaTime;

        [UnityTest]
        public IEnumerator WhileTheGameIsPaused_NothingMoves(
            [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update)] WingUpdateMode mode)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = mode);
            yield return Frames(30);
            Time.timeScale = 0f;
            yield return Frames(2);
            float beats = Beats(insect);
            long steps = WingSystem.StepCount;
            Vector3[] drawn = Shown(insect, 0).vertices;

            yield return Frames(30);

            Assert.That(Beats(insect), Is.EqualTo(beats));
            Assert.That(WingSystem.StepCount, Is.EqualTo(steps));
            Assert.That(Shown(insect, 0).vertices, Is.EqualTo(drawn));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AfterAPause_TheWingsGoOnWithoutAKick(
            [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update)] WingUpdateMode mode)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = mode);
            yield return Frames(60);
            float usual = 0f;
            yield return LargestMove(insect, 60, move => usual = move);

            float resumed = 0f;
            for (int pause = 0; pause < 5; pause++)
            {
                Time.timeScale = 0f;
                yield return Frames(7);
                // What happens to the body meanwhile is not felt.
                insect.transform.position += new Vector3(0f, 5f, 0f);
                insect.transform.Rotate(0f, 20f, 0f);
                yield return Frames(7);
                Time.timeScale = 1f;
                yield return LargestMove(insect, 13, move => resumed = math.max(resumed, move));
            }

            Assert.That(resumed, Is.LessThan(1.02f * usual));
        }

        [UnityTest]
        public IEnumerator AHitchOfASecond_IsNoKick(
            [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update, WingUpdateMode.UnscaledTime)] WingUpdateMode mode)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = mode);
            yield return Frames(60);
            float usual = 0f;
            yield return LargestMove(insect, 60, move => usual = move);
            float before = Beats(insect);

            Time.captureDeltaTime = 1f;
            yield return null;
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            float missed = Beats(insect) - before;
            float after = 0f;
            yield return LargestMove(insect, 60, move => after = move);

            // Unity itself cuts frames to a third of a second, the system to a quarter.
            Assert.That(missed, Is.LessThan(0.45f * k_RestingFrequency));
            Assert.That(after, Is.LessThan(1.02f * usual));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator AnInsectThatFliesOn_FeelsNoGustInAHitch()
        {
            InsectWings insect = Hatch();
            var velocity = new float3(0f, 0f, 12f);
            float worst = 0f;
            for (int frame = 0; frame < 120; frame++)
            {
                Time.captureDeltaTime = frame == 60 ? 0.3f : 1f / 60f;
                insect.transform.position += Time.deltaTime * (Vector3)velocity;
                yield return null;
                if (frame > 30)
                    worst = math.max(worst, math.distance(insect.Live.flight.velocity, velocity));
            }

            Assert.That(worst, Is.LessThan(0.02f * velocity.z));
        }

        [UnityTest]
        public IEnumerator UnscaledTime_GoesOnWhileTheGameIsPaused()
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.UnscaledTime);
            yield return Frames(10);
            Time.timeScale = 0f;
            yield return null;
            float start = Beats(insect), elapsed = 0f;
            while (elapsed < 1f)
            {
                yield return null;
                elapsed += Mathf.Min(Time.unscaledDeltaTime, 0.25f);
            }

            Assert.That(Beats(insect) - start, Is.EqualTo(k_RestingFrequency * elapsed).Within(0.05f * k_RestingFrequency));
        }

        [UnityTest]
        public IEnumerator ATimeScale_ScalesTheBeat_ButNotThatOfUnscaledTime([Values(0.1f, 3f)] float timeScale)
        {
            InsectWings scaled = Hatch(), unscaled = Hatch(made => made.UpdateMode = WingUpdateMode.UnscaledTime);
            yield return Frames(10);
            Time.timeScale = timeScale;
            yield return null;
            float scaledStart = Beats(scaled), unscaledStart = Beats(unscaled), scaledTime = 0f, unscaledTime = 0f;
            for (int frame = 0; frame < 120; frame++)
            {
                yield return null;
                scaledTime += Time.deltaTime;
                unscaledTime += Mathf.Min(Time.unscaledDeltaTime, 0.25f);
            }

            Assert.That(Beats(scaled) - scaledStart,
                Is.EqualTo(k_RestingFrequency * scaledTime).Within(0.05f * timeScale * k_RestingFrequency + 0.2f));
            Assert.That(Beats(unscaled) - unscaledStart, Is.EqualTo(k_RestingFrequency * unscaledTime).Within(0.05f * k_RestingFrequency));
        }

        [UnityTest]
        public IEnumerator AnotherUpdateModeWhilePlaying_IsFollowedWithoutAKick()
        {
            InsectWings insect = Hatch();
            yield return Frames(60);
            float usual = 0f;
            yield return LargestMove(insect, 60, move => usual = move);

            float worst = 0f;
            foreach (WingUpdateMode mode in new[]
            {
                WingUpdateMode.Update, WingUpdateMode.UnscaledTime, WingUpdateMode.FixedUpdate, WingUpdateMode.UnscaledTime,
                WingUpdateMode.Update,
                WingUpdateMode.FixedUpdate,
            })
            {
                insect.UpdateMode = mode;
                float before = Beats(insect);
                yield return LargestMove(insect, 30, move => worst = math.max(worst, move));
                Assert.That(Beats(insect), Is.GreaterThan(before + 3f), mode.ToString());
            }

            // A picture may show up to a step more or less than the frame before at the change.
            Assert.That(worst, Is.LessThan(2.5f * usual));
        }

        [UnityTest]
        public IEnumerator AnotherFixedStep_ChangesNothing([Values(0.005f, 0.1f)] float fixedDeltaTime)
        {
            InsectWings insect = Hatch();
            yield return Frames(30);
            Time.fixedDeltaTime = fixedDeltaTime;
            yield return Frames(12);

            float start = Beats(insect);
            double time = Time.fixedTimeAsDouble;
            yield return Frames(120);
            double elapsed = Time.fixedTimeAsDouble - time;
            Assert.That(Beats(insect) - start, Is.EqualTo(k_RestingFrequency * elapsed).Within(0.01f * k_RestingFrequency));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator AFastBeat_KeepsItsFrequencyInSlowSteps([Values(62f, 250f)] float frequency) => KeepsItsFrequency(frequency);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AVeryFastBeat_KeepsItsFrequencyInSlowSteps() => KeepsItsFrequency(600f);

        private IEnumerator KeepsItsFrequency(float frequency)
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            preset.Beat.maxFrequency = frequency;
            preset.Beat.frequencyFloor = 1f;
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(10);

            float start = Beats(insect);
            double time = Time.fixedTimeAsDouble;
            yield return Frames(60);
            double elapsed = Time.fixedTimeAsDouble - time;

            Assert.That(insect.Frequency, Is.EqualTo(frequency).Within(1e-3f * frequency));
            Assert.That(Beats(insect) - start, Is.EqualTo(frequency * elapsed).Within(0.01f * frequency));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        private static IEnumerator LargestMove(InsectWings insect, int frames, Action<float> tell)
        {
            float largest = 0f;
            Vector3[] last = Shown(insect, 0).vertices;
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                Vector3[] now = Shown(insect, 0).vertices;
                for (int v = 0; v < now.Length; v++)
                    largest = math.max(largest, (now[v] - last[v]).magnitude);
                last = now;
            }

            tell(largest);
        }
    }
}
