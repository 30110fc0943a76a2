using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Wings that a script steps by hand.</summary>
    public sealed class ManualTests : FlockFixture
    {
        private const float k_RestingFrequency = 0.8f * 11f;

        [UnityTest]
        public IEnumerator UnlessStepped_TheWingsStand()
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(3);
            float before = Beats(insect);
            Vector3[] drawn = Shown(insect, 0).vertices;
            yield return Frames(20);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Beats(insect), Is.EqualTo(before));
            Assert.That(Shown(insect, 0).vertices, Is.EqualTo(drawn));
        }

        [UnityTest]
        public IEnumerator AStep_TakesExactlyItsTime([Values(1e-5f, 0.003f, 1f / 60f, 0.02f, 0.11f, 0.25f)] float dt)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(2);
            float start = Beats(insect);
            for (int step = 0; step < 10; step++)
                insect.Step(dt);

            Assert.That(Beats(insect) - start, Is.EqualTo(10f * dt * k_RestingFrequency).Within(1e-4f + 1e-4f * dt));
        }

        [UnityTest]
        public IEnumerator ALongStep_IsCutAtAQuarterOfASecond([Values(0.26f, 1f, 1e6f, float.MaxValue)] float dt)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(2);
            float start = Beats(insect);
            insect.Step(dt);

            Assert.That(Beats(insect) - start, Is.EqualTo(0.25f * k_RestingFrequency).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator AStepOfNothing_DoesNothing()
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(2);
            insect.Step(0.05f);
            float start = Beats(insect);
            insect.Step(0f);

            Assert.That(Beats(insect), Is.EqualTo(start));
        }

        [UnityTest]
        public IEnumerator AStepOfNoTime_IsRefused([Values(-0.01f, float.NaN, float.PositiveInfinity, float.NegativeInfinity)] float dt)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            yield return Frames(2);

            Assert.That(() => insect.Step(dt), Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("0 or more"));
        }

        [UnityTest]
        public IEnumerator AStepInAnotherMode_IsRefused()
        {
            InsectWings insect = Hatch();
            yield return Frames(2);

            Assert.That(() => insect.Step(0.01f), Throws.InvalidOperationException.With.Message.Contains("FixedUpdate"));
        }

        [UnityTest]
        public IEnumerator AStepRightAfterTheBirth_IsTaken()
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            insect.Step(0.05f);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Beats(insect), Is.EqualTo(0.05f * k_RestingFrequency).Within(1e-3f));
            yield return Frames(3);
            Assert.That(Beats(insect), Is.EqualTo(0.05f * k_RestingFrequency).Within(1e-3f));
            Assert.That(Shown(insect, 0).vertices, Is.Not.EqualTo(WingMesh.vertices));
        }

        [UnityTest]
        public IEnumerator StepsOfADisabledOrBrokenInsect_DoNothing()
        {
            InsectWings disabled = Hatch(made =>
            {
                made.UpdateMode = WingUpdateMode.Manual;
                made.enabled = false;
            });
            InsectWings broken = Hatch(made =>
            {
                made.UpdateMode = WingUpdateMode.Manual;
                made.Wings[1].Renderer = null;
            });
            yield return Frames(2);
            disabled.Step(0.1f);
            broken.Step(0.1f);
            yield return null;

            Assert.That(disabled.State, Is.EqualTo(InsectState.Inactive));
            Assert.That(broken.State, Is.EqualTo(InsectState.NoRenderer));
        }

        [UnityTest]
        public IEnumerator StepsByHand_MoveNobodyElse()
        {
            InsectWings stepped = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            InsectWings still = Hatch(made => made.UpdateMode = WingUpdateMode.Manual), flying = Hatch(), twin = Hatch();
            yield return Frames(3);
            float before = Beats(still);
            for (int frame = 0; frame < 30; frame++)
            {
                stepped.Step(0.013f);
                yield return null;
            }

            Assert.That(Beats(still), Is.EqualTo(before));
            Assert.That(Farthest(Joints(flying, 0), Joints(twin, 0)), Is.LessThan(1e-6f));
            Assert.That(Beats(stepped), Is.EqualTo(30f * 0.013f * k_RestingFrequency).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator SteppedLikeTheClock_ItIsTheSameWing()
        {
            InsectWings stepped = Hatch(made => made.UpdateMode = WingUpdateMode.Manual), flying = Hatch();
            yield return Frames(2);
            float target = 2f + 0.25f;
            stepped.ResetState();
            flying.ResetState();
            double start = Time.fixedTimeAsDouble;
            while (Beats(flying) < target)
                yield return null;
            int steps = Mathf.RoundToInt((float)((Time.fixedTimeAsDouble - start) / Time.fixedDeltaTime));
            for (int step = 0; step < steps; step++)
                stepped.Step(Time.fixedDeltaTime);

            Assert.That(Beats(stepped), Is.EqualTo(Beats(flying)).Within(1e-3f));
            Assert.That(Farthest(Joints(stepped, 0), Joints(flying, 0)), Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator SteppedByHand_WindZonesAreFeltFromTheFirstStep()
        {
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            zone.windMain = 20f;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            insect.Step(0.01f);

            Assert.That(insect.Live.flight.wind.z, Is.EqualTo(20f).Within(1e-3f));
            yield return null;
        }
    }
}
