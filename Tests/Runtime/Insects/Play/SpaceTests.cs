using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Independence of the wings from place, size and orientation of the insect.</summary>
    public sealed class SpaceTests : FlockFixture
    {
        private const int k_Frames = 45;
        private const float k_Same = 0.01f;

        private static readonly Vector3[] s_Scales =
        {
            0.01f * Vector3.one, 100f * Vector3.one, new Vector3(1f, 2f, 1f), new Vector3(-1f, 1f, 1f), new Vector3(1f, 1f, -1f),
        };

        [UnityTest]
        public IEnumerator AScale_DoesNotChangeTheWing([ValueSource(nameof(s_Scales))] Vector3 scale, [Values] bool ofParent)
        {
            InsectWings plain = Hatch(), scaled = Hatch();
            Transform parent = Keep(new GameObject("parent")).transform;
            scaled.transform.SetParent(parent, false);
            (ofParent ? parent : scaled.transform).localScale = scale;
            yield return Compare(plain, scaled, frame => { });
        }

        [UnityTest]
        public IEnumerator AScaleThatChangesAllTheTime_DoesNotChangeTheWing([Values] bool ofParent)
        {
            InsectWings plain = Hatch(), scaled = Hatch();
            Transform parent = Keep(new GameObject("parent")).transform;
            scaled.transform.SetParent(parent, false);
            Transform changing = ofParent ? parent : scaled.transform;
            yield return Compare(plain, scaled, frame => changing.localScale = (1.5f + math.sin(0.3f * frame)) * Vector3.one);
        }

        [UnityTest]
        public IEnumerator AScaleThatPassesThroughZero_LeavesTheWingWhole()
        {
            InsectWings plain = Hatch(), scaled = Hatch();
            yield return Frames(2);
            for (int frame = 0; frame <= 60; frame++)
            {
                // Over zero to the mirror image and back, twice.
                scaled.transform.localScale = math.cos(2f * math.PI * frame / 30f) * new Vector3(1f, 0f, 0f) + new Vector3(0f, 1f, 1f);
                if (frame % 15 == 0)
                    scaled.transform.localScale = Vector3.zero;
                yield return null;
                Assert.That(math.all(math.isfinite(Joints(scaled, 0)[24])));
            }

            scaled.transform.localScale = Vector3.one;
            yield return Frames(30);
            Assert.That(scaled.State, Is.EqualTo(InsectState.Ready));
            Assert.That(WingSystem.ResetCount, Is.Zero);
            Assert.That(Farthest(Joints(plain, 0), Joints(scaled, 0)), Is.LessThan(k_Same));
        }

        [UnityTest]
        public IEnumerator OneMeshForBothWings_GivesMirrorImages()
        {
            InsectWings insect = Hatch(made => made.Air.wind = new Vector3(0f, 0.5f, -3f));
            yield return Frames(k_Frames);
            float worst = 0f, moved = 0f;
            Vector3[] right = Shown(insect, 0).vertices, left = Shown(insect, 1).vertices, rest = WingMesh.vertices;
            for (int v = 0; v < right.Length; v++)
            {
                worst = math.max(worst, (right[v] - left[v]).magnitude);
                moved = math.max(moved, (right[v] - rest[v]).magnitude);
            }

            // In the space of their mesh they are the same; the scale mirrors what is drawn.
            Assert.That(worst, Is.LessThan(1e-4f));
            Assert.That(moved, Is.GreaterThan(0.1f));
            Vector3 rightTip = insect.JointPosition(0, 0, 4), leftTip = insect.JointPosition(1, 0, 4);
            Assert.That((Vector3.Scale(leftTip, new Vector3(-1f, 1f, 1f)) - rightTip).magnitude, Is.LessThan(1e-4f));
        }

        [UnityTest]
        public IEnumerator AMirroredInsect_BendsUnderWindAsItsMirrorImage()
        {
            var wind = new Vector3(4f, 1f, -3f);
            InsectWings plain = Hatch(made => made.Air.wind = wind);
            InsectWings mirrored = Hatch(made =>
            {
                made.transform.localScale = new Vector3(-1f, 1f, 1f);
                made.Air.wind = Vector3.Scale(wind, new Vector3(-1f, 1f, 1f));
            });
            yield return Frames(k_Frames);

            Assert.That(Farthest(Joints(plain, 0), Joints(mirrored, 0)), Is.LessThan(1e-4f));
            Assert.That(Farthest(Joints(plain, 1), Joints(mirrored, 1)), Is.LessThan(1e-4f));
            Assert.That(Farthest(Joints(plain, 0), Joints(plain, 1)), Is.GreaterThan(1e-3f), "the cross wind is not felt");
        }

        [UnityTest]
        public IEnumerator ATurnedInsectInTurnedWind_BeatsTheSame()
        {
            var turn = Quaternion.Euler(0f, 130f, 0f);
            var wind = new Vector3(1f, 0f, -5f);
            InsectWings plain = Hatch(made => made.Air.wind = wind);
            InsectWings turned = Hatch(made =>
            {
                made.transform.rotation = turn;
                made.Air.wind = turn * wind;
            });
            yield return Frames(k_Frames);

            Assert.That(Farthest(Joints(plain, 0), Joints(turned, 0)), Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator FlyingIsLikeWindTheOtherWay()
        {
            // At a quarter of the speed that drives the beat harder, so that both beat as at rest.
            var velocity = new Vector3(0f, 0f, 8f);
            InsectWings windy = Hatch(made =>
            {
                made.Motion.source = VelocitySource.Script;
                made.Air.wind = -velocity;
            });
            InsectWings flying = Hatch();
            for (int frame = 0; frame < 90; frame++)
            {
                flying.transform.position += velocity / 60f;
                yield return null;
            }

            Assert.That(math.distance(flying.Live.flight.velocity, velocity), Is.LessThan(0.01f * velocity.z));
            Assert.That(Farthest(Joints(windy, 0), Joints(flying, 0)), Is.LessThan(k_Same));
        }

        [UnityTest]
        public IEnumerator MovedInFixedStepsAlone_ItFeelsASteadySpeed([Values(24f, 60f, 144f, 400f)] float frameRate)
        {
            const float speed = 12f;
            Time.captureDeltaTime = 1f / frameRate;
            InsectWings insect = Hatch();
            double start = Time.fixedTimeAsDouble, end = start + 2.0;
            float least = float.PositiveInfinity, most = 0f;
            while (Time.timeAsDouble < end)
            {
                // Where a body without interpolation is drawn.
                insect.transform.position = new Vector3(0f, 0f, (float)(speed * (Time.fixedTimeAsDouble - start)));
                yield return null;
                if (Time.timeAsDouble < start + 1.0)
                    continue;
                least = math.min(least, insect.Live.flight.velocity.z);
                most = math.max(most, insect.Live.flight.velocity.z);
            }

            Assert.That(least, Is.GreaterThan(0.75f * speed));
            Assert.That(most, Is.LessThan(1.25f * speed));
        }

        [UnityTest]
        public IEnumerator ASpinningParent_BlowsAtTheWingsByItsRate()
        {
            const float rate = 4f, arm = 3f;
            Transform parent = Keep(new GameObject("parent")).transform;
            InsectWings insect = Hatch();
            insect.transform.SetParent(parent, false);
            insect.transform.localPosition = new Vector3(arm, 0f, 0f);
            for (int frame = 1; frame < 90; frame++)
            {
                parent.rotation = Quaternion.Euler(0f, math.degrees(rate) * frame / 60f, 0f);
                yield return null;
            }

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(((Vector3)insect.Live.flight.angularVelocity - rate * Vector3.up).magnitude, Is.LessThan(0.02f * rate));
            Assert.That(((Vector3)insect.Live.flight.velocity).magnitude, Is.EqualTo(rate * arm).Within(0.1f * rate * arm));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator AVeryFastSpin_BreaksNothing()
        {
            InsectWings insect = Hatch();
            for (int frame = 1; frame < 60; frame++)
            {
                insect.transform.rotation = Quaternion.Euler(31f * frame, 97f * frame, 53f * frame);
                yield return null;
            }

            Assert.That(WingSystem.ResetCount, Is.Zero);
            foreach (float3 joint in Joints(insect, 0))
                Assert.That(math.length(joint), Is.LessThan(1.5f));
        }

        private static IEnumerator Compare(InsectWings plain, InsectWings other, Action<int> change)
        {
            float worst = 0f;
            for (int frame = 0; frame < k_Frames; frame++)
            {
                change(frame);
                yield return null;
                for (int wing = 0; wing < 2 && frame > 1; wing++)
                    worst = math.max(worst, Farthest(Joints(plain, wing), Joints(other, wing)));
            }

            Assert.That(worst, Is.LessThan(k_Same));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }
    }
}
