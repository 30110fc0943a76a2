using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Forces, and what an insect feels of its flight and the wind.</summary>
    public sealed class AirTests : PlayFixture
    {
        private const float k_Weight = 0.428e-3f * 9.81f;

        [UnityTest]
        public IEnumerator AMonarchsMeanLift_IsThatOfTheModel()
        {
            // The model's own figures at 1.3 m/s, ten units a metre.
            foreach ((float pitch, float expected) in new[] { (0f, 0f), (18.6f, 0.67f), (30f, 1.02f) })
            {
                InsectWings insect = Insect();
                insect.Motion.source = VelocitySource.Script;
                insect.Velocity = new Vector3(0f, 0f, 13f);
                insect.transform.rotation = Quaternion.Euler(-pitch, 0f, 0f);
                yield return Frames(60);
                float lift = 0f, drag = 0f, newtons = 0f;
                yield return Mean(insect, 6f, (l, d, n) => (lift, drag, newtons) = (l, d, n));

                Assert.That(lift, Is.EqualTo(expected).Within(0.2f), $"pitch {pitch}");
                Assert.That(newtons, Is.EqualTo(lift * k_Weight).Within(0.01f * k_Weight));
                UnityEngine.Object.Destroy(insect.gameObject);
                yield return Frames(2);
            }
        }

        [UnityTest]
        public IEnumerator Forces_TurnWithTheInsect_AndAddUp()
        {
            InsectWings insect = Insect();
            insect.UpdateMode = WingUpdateMode.Manual;
            insect.Air.windZones = false;
            insect.Step(0.1f);
            Vector3 level = insect.AirForce, left = insect.AirForceOf(1), right = insect.AirForceOf(0);

            Assert.That((level - left - right).magnitude, Is.LessThan(1e-3f * level.magnitude));
            Assert.That((Vector3.Scale(left, new Vector3(-1f, 1f, 1f)) - right).magnitude, Is.LessThan(1e-3f * right.magnitude));
            Assert.That(math.abs(level.x), Is.LessThan(1e-3f * level.magnitude), "the two sides do not cancel");
            Assert.That(insect.Lift, Is.EqualTo(level.y).Within(1e-6f * level.magnitude));

            insect.transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            insect.Teleport();
            insect.ResetState();
            insect.Step(0.1f);
            Assert.That((insect.AirForce - Quaternion.Euler(0f, 90f, 0f) * level).magnitude, Is.LessThan(0.01f * level.magnitude));
            yield return null;
        }

        [UnityTest]
        public IEnumerator TheDownstroke_Lifts_AndTheUpstrokePushesDown()
        {
            InsectWings insect = Insect();
            insect.UpdateMode = WingUpdateMode.Manual;
            insect.Step(1f / 8.8f);
            float down = 0f, up = 0f;
            for (int step = 0; step < 40; step++)
            {
                insect.Step(1f / (8.8f * 40f));
                float phase = insect.Phase;
                down += phase > 30f && phase < 150f ? insect.Lift : 0f;
                up += phase > 210f && phase < 330f ? insect.Lift : 0f;
            }

            Assert.That(down, Is.GreaterThan(0f));
            Assert.That(up, Is.LessThan(0f));
            yield return null;
        }

        [UnityTest]
        public IEnumerator TheWindBehind_Pushes_AndDragIsAgainstTheFlight()
        {
            foreach (float wind in new[] { -40f, 40f })
            {
                InsectWings insect = Insect();
                insect.Air.wind = new Vector3(0f, 0f, wind);
                yield return Frames(60);
                float lift = 0f, drag = 0f, z = 0f;
                for (int frame = 0; frame < 68; frame++)
                {
                    yield return null;
                    drag += insect.Drag;
                    z += insect.AirForce.z;
                    lift += insect.Lift;
                }

                Assert.That(math.sign(z), Is.EqualTo(math.sign(wind)));
                Assert.That(drag, Is.GreaterThan(0f));
                UnityEngine.Object.Destroy(insect.gameObject);
                yield return Frames(2);
            }
        }

        [UnityTest]
        public IEnumerator InStillAir_ThereIsNoDragToSpeakOf()
        {
            InsectWings insect = Insect();
            yield return Frames(20);

            Assert.That(insect.Drag, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ScriptVelocity_DrivesTheBeat()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Script;
            yield return Frames(30);
            Assert.That(insect.Frequency, Is.EqualTo(8.8f).Within(0.01f));

            // 2 m/s is u_max: all but full drive; ten units a metre.
            insect.Velocity = new Vector3(0f, 0f, 20f);
            yield return Frames(60);
            Assert.That(insect.Frequency, Is.EqualTo(11f).Within(0.02f));
            Assert.That(insect.FlapRange, Is.EqualTo(120f).Within(0.2f));
        }

        [UnityTest]
        public IEnumerator ScriptVelocityOfNonsense_DoesNoHarm()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Script;
            yield return Frames(10);
            foreach (Vector3 velocity in new[] { new Vector3(float.NaN, 0f, 0f), new Vector3(0f, float.PositiveInfinity, 0f),
                1e30f * Vector3.one, 1e5f * Vector3.one })
            {
                insect.Velocity = velocity;
                yield return Frames(10);
            }

            insect.Velocity = Vector3.zero;
            yield return Frames(60);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(insect.Frequency, Is.EqualTo(8.8f).Within(0.01f));
            foreach (Vector3 vertex in Shown(insect, 0).vertices)
                Assert.That(vertex.magnitude, Is.LessThan(1f));
        }

        [UnityTest]
        public IEnumerator MetresPerUnit_SaysHowFastAUnitIs()
        {
            InsectWings lifeSize = Insect(), fixedScale = Insect();
            foreach (InsectWings insect in new[] { lifeSize, fixedScale })
            {
                insect.Motion.source = VelocitySource.Script;
                insect.Velocity = new Vector3(0f, 0f, 2f);
            }

            fixedScale.Motion.metresPerUnit = 1f;
            yield return Frames(60);
            Assert.That(lifeSize.Frequency, Is.EqualTo(8.8f).Within(0.02f), "a ten-fold monarch at two units a second flies at 0.2 m/s");
            Assert.That(fixedScale.Frequency, Is.EqualTo(11f).Within(0.02f));
        }

        [UnityTest]
        public IEnumerator ARigidbody_TellsItsVelocityAndTurn()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Rigidbody;
            Rigidbody body = Keep(new GameObject("body")).AddComponent<Rigidbody>();
            body.useGravity = false;
            insect.transform.SetParent(body.transform, false);
            insect.transform.localPosition = new Vector3(0f, 0f, 2f);
            body.AddForce(new Vector3(0f, 0f, 6f), ForceMode.VelocityChange);
            yield return Frames(5);
            body.angularVelocity = new Vector3(0f, 3f, 0f);
            yield return Frames(2);

            float3 expected = body.GetPointVelocity(insect.transform.position);
            Assert.That(math.length(expected), Is.EqualTo(math.sqrt(72f)).Within(1f), "six ahead, three times two aside");
            Assert.That(math.distance(insect.Live.flight.velocity, expected), Is.LessThan(0.5f));
            Assert.That(insect.Live.flight.angularVelocity.y, Is.EqualTo(3f).Within(0.2f));
        }

        [UnityTest]
        public IEnumerator WithoutARigidbody_ThatSource_IsStillAir()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Rigidbody;
            yield return Frames(5);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));

            Rigidbody body = insect.gameObject.AddComponent<Rigidbody>();
            body.useGravity = false;
            body.AddForce(new Vector3(0f, 0f, 4f), ForceMode.VelocityChange);
            yield return Frames(5);
            Assert.That(insect.Live.flight.velocity.z, Is.EqualTo(4f).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator ARigidbodyCarriedByLift_Climbs()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Rigidbody;
            insect.transform.rotation = Quaternion.Euler(-35f, 0f, 0f);
            Rigidbody body = insect.gameObject.AddComponent<Rigidbody>();
            body.useGravity = false;
            yield return null;
            // Twenty units a second ahead: 2 m/s for this ten-fold monarch.
            body.AddForce(new Vector3(0f, 0f, 20f), ForceMode.VelocityChange);
            yield return Frames(60);
            float lift = 0f;
            yield return Mean(insect, 4f, (l, d, n) => lift = l);

            Assert.That(lift, Is.GreaterThan(0.8f), "pitched up and fast it must carry about its weight");
        }

        [UnityTest]
        public IEnumerator WithoutGravity_ThereIsNoPitchAndNoLift()
        {
            Vector3 gravity = Physics.gravity;
            Physics.gravity = Vector3.zero;
            InsectWings insect = Insect();
            insect.transform.rotation = Quaternion.Euler(-50f, 0f, 0f);
            yield return Frames(20);
            float pitch = insect.AngleOfAttack, lift = insect.Lift, ratio = insect.LiftOverWeight;
            Physics.gravity = gravity;

            Assert.That(new[] { pitch, lift, ratio }, Is.All.Zero);
            Assert.That(insect.AirForce.magnitude, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator InAWindFromTheSide_TheWingsBendTowardsIt()
        {
            InsectWings windy = Insect(), calm = Insect();
            windy.Air.wind = new Vector3(0f, 40f, 0f);
            yield return Frames(60);
            float higher = 0f;
            for (int frame = 0; frame < 41; frame++)
            {
                yield return null;
                higher += windy.Read(0).JointPosition(4, 4).y - calm.Read(0).JointPosition(4, 4).y;
            }

            Assert.That(higher / 41f, Is.GreaterThan(0.005f));
        }

        // Means over some beats, weighted by time: forces are means over a fixed step each.
        private static IEnumerator Mean(InsectWings insect, float beats, Action<float, float, float> tell)
        {
            float lift = 0f, drag = 0f, newtons = 0f;
            int count = 0;
            WingReading start = insect.Read(0);
            float end = start.Beats + start.Phase / (2f * math.PI) + beats;
            while (insect.Read(0).Beats + insect.Read(0).Phase / (2f * math.PI) < end)
            {
                yield return new WaitForFixedUpdate();
                lift += insect.LiftOverWeight;
                newtons += insect.Lift;
                drag += insect.Drag;
                count++;
            }

            tell(lift / count, drag / count, newtons / count);
        }
    }
}
