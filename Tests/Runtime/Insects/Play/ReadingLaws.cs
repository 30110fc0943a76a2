using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Readings of an insect in the units of its wings, each of a size of its own, and along its flight and its gravity.</summary>
    public sealed class ReadingLaws : FlockFixture
    {
        private Vector3 m_Gravity;

        [SetUp]
        public void NoteGravity() => m_Gravity = Physics.gravity;

        [TearDown]
        public void GiveGravityBack() => Physics.gravity = m_Gravity;

        // Forces are in masses and lengths of the wing that bears them; so are moments and powers, with another length.
        [UnityTest]
        public IEnumerator Readings_AreInTheUnitsOfEachWing([Values] bool turned)
        {
            InsectWings insect = Living(turned);
            yield return Stepped(insect);
            Vector3 force = default, moment = default;
            float power = 0f, stretch = 0f;
            for (int wing = 0; wing < 2; wing++)
            {
                PresetSize size = insect.Wings[wing].Preset.Size;
                WingReading reading = insect.Read(wing);
                PlacedWing placed = insect.Live.wings[wing].placed;
                Vector3 own = placed.ToWorld(reading.AirForce) * (size.wingMass * size.wingLength);
                Vector3 turn = placed.AxisToWorld(reading.AirMoment) * (size.wingMass * size.wingLength * size.wingLength);
                Near(insect.AirForceOf(wing), own);
                Near(insect.AirMomentOf(wing), turn);
                force += own;
                moment += turn;
                power += reading.AirPower * size.wingMass * size.wingLength * size.wingLength;
                stretch = math.max(stretch, reading.Stretch);
                Assert.That(reading.Stretch, Is.Positive);
            }

            Near(insect.AirForce, force);
            Near(insect.AirMoment, moment);
            Assert.That(insect.AirPower, Is.Not.Zero.And.EqualTo(power).Within(1e-3).Percent);
            Assert.That(insect.Stretch, Is.EqualTo(stretch));
            Assert.That(insect.Read(0).Stretch, Is.Not.EqualTo(insect.Read(1).Stretch));
        }

        [UnityTest]
        public IEnumerator Lift_IsAgainstGravity_AndDragAgainstTheWayThroughTheAir()
        {
            Physics.gravity = new Vector3(6f, -8f, 0f);
            InsectWings insect = Living(false);
            insect.Preset = Keep(InsectCatalogue.Monarch());
            yield return Stepped(insect);
            Vector3 force = insect.AirForce, through = new Vector3(0f, 1f, 2f) - new Vector3(3f, 0f, -1f);
            Assert.That(insect.Lift, Is.EqualTo(Vector3.Dot(force, new Vector3(-0.6f, 0.8f, 0f))).Within(1e-3).Percent);
            Assert.That(insect.Drag, Is.EqualTo(-Vector3.Dot(force, through) / through.magnitude).Within(1e-3).Percent);
            float weight = 10f * insect.Wings[0].Preset.Size.insectMass;
            Assert.That(insect.LiftOverWeight, Is.EqualTo(insect.Lift / weight).Within(1e-3).Percent);
            WingReading first = insect.Read(0);
            Assert.That(insect.FlapRange, Is.EqualTo(360f / math.PI * first.Amplitude.x).Within(1e-3).Percent);
            Assert.That(insect.Phase, Is.EqualTo(180f / math.PI * first.Phase).Within(1e-3).Percent);
            Assert.That(insect.Frequency, Is.EqualTo(first.Frequency));
            Physics.gravity = Vector3.zero;
            Assert.That((insect.Lift, insect.LiftOverWeight), Is.EqualTo((0f, 0f)));
        }

        [UnityTest]
        public IEnumerator OfADeadInsect_AllIsNought_AndItsWingsAreStillCounted()
        {
            InsectWings insect = Hatch(made => made.enabled = false);
            yield return null;
            Assert.That(new[] { insect.AirPower, insect.Stretch, insect.AngleOfAttack, insect.Drag, insect.Lift }, Is.All.Zero);
            Assert.That((insect.Detail, insect.BoundsOf(1)), Is.EqualTo((WingDetail.Frozen, default(Bounds))));
            Vector3[] vectors =
                { insect.AirForce, insect.AirMoment, insect.AirForceOf(1), insect.AirMomentOf(1), insect.JointPosition(1, 0, 0) };
            Assert.That(vectors, Is.All.EqualTo(Vector3.zero));
            foreach (int wing in new[] { -1, 2 })
            {
                foreach (TestDelegate read in new TestDelegate[]
                {
                    () => insect.Read(wing), () => insect.BoundsOf(wing), () => insect.AirForceOf(wing), () => insect.AirMomentOf(wing),
                    () => insect.JointPosition(wing, 0, 0),
                })
                {
                    Assert.That(
                        read, Throws.InstanceOf<System.ArgumentOutOfRangeException>().With.Message.Contains("'insect' has 2 wings."));
                }
            }
        }

        private static IEnumerator Stepped(InsectWings insect)
        {
            yield return Frames(2);
            insect.Step(0.17f);
        }

        // The right wing is larger, or the left one.
        private InsectWings Living(bool leftIsLarge) => Hatch(made =>
        {
            made.UpdateMode = WingUpdateMode.Manual;
            made.transform.rotation = Quaternion.Euler(20f, 70f, 10f);
            made.Motion.source = VelocitySource.Script;
            made.Velocity = new Vector3(0f, 1f, 2f);
            made.Air.wind = new Vector3(3f, 0f, -1f);
            made.Motion.metresPerUnit = 1f;
            for (int wing = 0; wing < 2; wing++)
            {
                WingPreset preset = Keep(InsectCatalogue.Monarch());
                if (leftIsLarge == (wing == 1))
                    (preset.Size.wingLength, preset.Size.wingMass) = (0.08f, 5e-5f);
                made.Wings[wing].Preset = preset;
            }
        });

        private static void Near(Vector3 found, Vector3 wanted)
        {
            Assert.That(wanted.magnitude, Is.Positive);
            Assert.That((found - wanted).magnitude, Is.LessThan(1e-5f * wanted.magnitude));
        }
    }
}
