using System;
using System.Collections;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play
{
    /// <summary>Readings of an insect, compared with the state of its wings.</summary>
    public sealed class ReadingTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator WingBeat_ComesOnceABeat()
        {
            InsectWings insect = Hatch();
            int calls = 0, unityCalls = 0;
            insect.WingBeat += heard =>
            {
                Assert.That(heard, Is.SameAs(insect));
                Assert.That(heard.Phase, Is.LessThan(90f), "the call comes long after the start of the beat");
                calls++;
            };
            insect.OnWingBeat.AddListener(() => unityCalls++);
            yield return Frames(123);

            int beats = insect.Read(0).Beats;
            Assert.That(beats, Is.GreaterThan(15));
            Assert.That(calls, Is.EqualTo(beats));
            Assert.That(unityCalls, Is.EqualTo(beats));
        }

        [UnityTest]
        public IEnumerator AListenerThatFails_KeepsNeitherTheInspectorsEventNorOtherInsectsFromBeingCalled()
        {
            InsectWings insect = Hatch(), other = Hatch();
            int unityCalls = 0, otherCalls = 0;
            insect.WingBeat += _ => throw new InvalidOperationException("a listener's own fault");
            insect.OnWingBeat.AddListener(() => unityCalls++);
            other.WingBeat += _ => otherCalls++;
            LogAssert.ignoreFailingMessages = true;
            yield return Frames(20);

            Assert.That(unityCalls, Is.GreaterThan(1));
            Assert.That(otherCalls, Is.EqualTo(unityCalls));
        }

        [UnityTest]
        public IEnumerator OfManyBeatsInAFrame_OneIsTold()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            preset.Beat.maxFrequency = 600f;
            InsectWings insect = Hatch(made => made.Preset = preset);
            yield return Frames(5);
            int calls = 0, frame = 0, most = 0;
            insect.WingBeat += _ =>
            {
                most = frame == Time.frameCount ? most + 1 : 1;
                frame = Time.frameCount;
                calls++;
            };
            yield return Frames(30);

            Assert.That(most, Is.EqualTo(1));
            Assert.That(calls, Is.InRange(20, 31));
        }

        [UnityTest]
        public IEnumerator AListener_MayDestroyDisableOrMakeInsects(
            [Values("destroy", "immediately", "disable", "other", "make", "step")] string deed)
        {
            InsectWings insect = Hatch(), other = Hatch(), witness = Hatch(), made = null;
            int calls = 0, witnessed = 0;
            witness.WingBeat += _ => witnessed++;
            insect.WingBeat += _ =>
            {
                calls++;
                switch (deed)
                {
                    case "destroy": Object.Destroy(insect.gameObject); break;
                    case "immediately": Object.DestroyImmediate(insect.gameObject); break;
                    case "disable": insect.enabled = false; break;
                    case "other" when other != null: Object.DestroyImmediate(other.gameObject); break;
                    case "make": made = made == null ? Hatch() : made; break;
                    case "step":
                        other.UpdateMode = WingUpdateMode.Manual;
                        other.Step(0.2f);
                        break;
                    default:
                        break;
                }
            };
            yield return Frames(40);

            bool ends = deed == "destroy" || deed == "immediately" || deed == "disable";
            Assert.That(calls, ends ? Is.EqualTo(1) : Is.GreaterThan(2));
            Assert.That(witnessed, Is.GreaterThan(2));
            Assert.That(witness.State, Is.EqualTo(InsectState.Ready));
            if (deed == "make")
                Assert.That(made.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator TheLastInsect_MayDestroyItselfAtItsBeat()
        {
            InsectWings insect = Hatch();
            insect.WingBeat += _ => Object.DestroyImmediate(insect.gameObject);
            yield return Frames(30);

            Assert.That(insect == null, Is.True);
            Assert.That(WingSystem.Loop, Is.Null);
        }

        [UnityTest]
        public IEnumerator AListenerThatThrows_KeepsNobodyFromHearing()
        {
            InsectWings first = Hatch(), second = Hatch();
            int thrown = 0, heard = 0;
            first.WingBeat += _ =>
            {
                if (thrown++ == 0)
                    throw new InvalidOperationException("oops");
            };
            second.WingBeat += _ => heard++;
            LogAssert.Expect(LogType.Exception, new Regex("oops"));
            yield return Frames(60);

            Assert.That(heard, Is.EqualTo(second.Read(0).Beats));
            Assert.That(thrown, Is.EqualTo(first.Read(0).Beats));
        }

        [UnityTest]
        public IEnumerator AResetBeat_IsToldAgain()
        {
            InsectWings insect = Hatch();
            yield return Frames(60);
            int calls = 0;
            insect.WingBeat += _ => calls++;
            insect.ResetState();
            yield return Frames(1);
            Assert.That(Beats(insect), Is.LessThan(0.5f));
            yield return Frames(30);
            Assert.That(calls, Is.EqualTo(insect.Read(0).Beats));
        }

        [UnityTest]
        public IEnumerator FrequencyFlapRangeAndPhase_AreThoseOfTheWing()
        {
            InsectWings insect = Hatch();
            yield return Frames(20);

            Assert.That(insect.Frequency, Is.EqualTo(8.8f).Within(1e-3f));
            Assert.That(insect.FlapRange, Is.EqualTo(60f).Within(1e-3f), "half of the monarch's 120 degrees, at rest");
            float before = insect.Phase;
            yield return Frames(6);
            Assert.That(
                Mathf.Repeat(insect.Phase - before, 360f), Is.EqualTo(Mathf.Repeat(8.8f * 0.1f * 360f, 360f)).Within(0.02f * 8.8f * 360f));
            Assert.That(insect.Read(0).JointPosition(0, 0).y, Is.EqualTo(0f).Within(0.05f));
        }

        [UnityTest]
        public IEnumerator ForceAndMoment_AreSumsOfTheWings_MirroredLeftAndRight_AndTurnWithTheInsect()
        {
            InsectWings one = Hatch(made => made.UpdateMode = WingUpdateMode.Manual),
                turned = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            turned.transform.SetPositionAndRotation(new Vector3(40f, 3f, -7f), Quaternion.Euler(0f, 90f, 0f));
            yield return null;
            one.Step(0.21f);
            turned.Step(0.21f);
            yield return null;
            Vector3 right = one.AirMomentOf(0), left = one.AirMomentOf(1), force = one.AirForceOf(0);

            // Forces are mirrored in the plane between both sides, moments the other way round.
            Near(Vector3.Scale(one.AirForceOf(1), new Vector3(-1f, 1f, 1f)), force, 1e-3f);
            Near(Vector3.Scale(left, new Vector3(1f, -1f, -1f)), right, 1e-3f);
            Near(one.AirMoment, right + left, 1e-5f);
            Near(one.AirForce, force + one.AirForceOf(1), 1e-5f);
            Near(turned.AirMoment, turned.transform.rotation * one.AirMoment, 2e-2f);

            // An arm of a part of the wing's 61 mm, the hinge's place counted in.
            float arm = right.magnitude / force.magnitude;
            Assert.That(arm, Is.InRange(0.01f, 0.061f), "metres");
            Assert.That(() => one.AirMomentOf(2), Throws.TypeOf<ArgumentOutOfRangeException>());
            one.enabled = false;
            Assert.That((one.AirMoment, one.AirMomentOf(0), one.AirForce), Is.EqualTo((Vector3.zero, Vector3.zero, Vector3.zero)));
        }

        private static void Near(Vector3 one, Vector3 other, float share) =>
            Assert.That((one - other).magnitude, Is.LessThan(share * other.magnitude), $"{one} and {other}");

        [UnityTest]
        public IEnumerator Pitch_IsReadInDegrees_NoseUpPositive([Values(-40f, 0f, 25f, 80f)] float pitch)
        {
            InsectWings insect = Hatch(made => made.transform.rotation = Quaternion.Euler(-pitch, 70f, 0f));
            yield return Frames(5);

            Assert.That(insect.AngleOfAttack, Is.EqualTo(pitch).Within(0.01f));
        }

        // Eq. 6 and 7: the wings are told the pitch of their body, nose up positive.
        [UnityTest]
        public IEnumerator NoseUp_WingsBeatFaster_ThanNoseDown()
        {
            InsectWings up = Hatch(made => made.transform.rotation = Quaternion.Euler(-60f, 0f, 0f)),
                down = Hatch(made => made.transform.rotation = Quaternion.Euler(60f, 0f, 0f));
            yield return Frames(60);

            Assert.That(up.Read(0).Beats, Is.GreaterThan(1), "a beat that began with the pitch known");
            Assert.That(up.Read(0).Frequency, Is.GreaterThan(1.02f * down.Read(0).Frequency));
        }

        [UnityTest]
        public IEnumerator JointPositions_AreOnTheDeformedMesh([Values] bool mirrored)
        {
            InsectWings insect = Hatch(made =>
            {
                made.transform.SetPositionAndRotation(new Vector3(5f, 3f, -2f), Quaternion.Euler(20f, 130f, 10f));
                made.transform.localScale = 2f * Vector3.one;
                made.UpdateMode = WingUpdateMode.Manual;
            });
            insect.Step(0.21f);
            yield return Frames(2);
            int wing = mirrored ? 1 : 0;
            Transform drawn = insect.Wings[wing].Renderer.transform;
            Vector3[] authored = WingMesh.vertices, now = Shown(insect, wing).vertices;
            Vector3[] rest = Array.ConvertAll(Order(insect, wing), v => authored[v]);
            WingReading reading = insect.Read(wing);
            float worst = 0f;
            for (int chain = 0; chain < reading.ChainCount; chain++)
            {
                for (int joint = 0; joint < reading.JointsPerChain; joint++)
                {
                    // What the vertex nearest to the joint does, the joint does.
                    Vector3 at = Skeleton.GetJoint(chain, joint);
                    int nearest = 0;
                    for (int v = 1; v < rest.Length; v++)
                        nearest = (rest[v] - at).sqrMagnitude < (rest[nearest] - at).sqrMagnitude ? v : nearest;
                    float apart = (rest[nearest] - at).magnitude;
                    float error = (drawn.TransformPoint(now[nearest]) - insect.JointPosition(wing, chain, joint)).magnitude / 2f;
                    worst = math.max(worst, math.abs(error - apart));
                }
            }

            Assert.That(worst, Is.LessThan(0.03f));
            Assert.That(() => insect.JointPosition(wing, 5, 0), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [UnityTest]
        public IEnumerator Bounds_HoldTheJoints()
        {
            InsectWings insect = Hatch(made => made.UpdateMode = WingUpdateMode.Manual);
            insect.Step(0.13f);
            yield return Frames(2);
            Bounds bounds = insect.BoundsOf(0);
            bounds.Expand(0.05f);
            for (int joint = 0; joint < 5; joint++)
                Assert.That(bounds.Contains(insect.Wings[0].Renderer.transform.InverseTransformPoint(insect.JointPosition(0, 2, joint))));
        }

        [UnityTest]
        public IEnumerator JointPosition_IsOnTheDrawnWing_AtFrameRatesAboveTheSteps()
        {
            Time.captureDeltaTime = 1f / 240f;
            InsectWings insect = Hatch();
            yield return Frames(60);
            Vector3 last = default;
            float step = 0f;
            for (int frame = 0; frame < 24; frame++)
            {
                yield return new WaitForEndOfFrame();
                Vector3 joint = insect.JointPosition(0, 2, 3);
                if (frame > 0)
                    step = Mathf.Max(step, (joint - last).magnitude);
                last = joint;
                Vector3[] drawn = Shown(insect, 0).vertices;
                float nearest = float.MaxValue;
                foreach (Vector3 vertex in drawn)
                    nearest = Mathf.Min(nearest, (insect.Wings[0].Renderer.transform.TransformPoint(vertex) - joint).magnitude);
                Assert.That(nearest, Is.LessThan(0.06f), "the joint is beside the drawn wing");
                yield return null;
            }

            Assert.That(step, Is.InRange(1e-3f, 0.3f), "it moves with the pictures, not by whole steps");
        }
    }
}
