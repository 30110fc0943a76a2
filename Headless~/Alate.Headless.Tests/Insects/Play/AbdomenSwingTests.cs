using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Abdomens that swing with the wings of an insect in play.</summary>
    public sealed class AbdomenSwingTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator ItIsWhereThePhaseOfTheBeatSays([Values(0f, 100f, 250f)] float lowest, [Values(5f, 20f)] float swing)
        {
            AbdomenSwing abdomen = Monarch(out InsectWings wings);
            abdomen.Swing = swing;
            abdomen.LowestPhase = lowest;
            float highest = float.NegativeInfinity, deepest = float.PositiveInfinity;
            for (int frame = 0; frame < 40; frame++)
            {
                yield return new WaitForEndOfFrame();
                // The tail is behind.
                Vector3 tail = abdomen.transform.localRotation * Vector3.back;
                float up = Mathf.Rad2Deg * Mathf.Atan2(tail.y, -tail.z);
                if (frame < 3)
                    continue;
                float shown = wings.Phase - 360f * wings.Frequency * Time.fixedDeltaTime * (1f - wings.DrawnAlpha);
                Assert.That(up, Is.EqualTo(-swing * Mathf.Cos(Mathf.Deg2Rad * (shown - lowest))).Within(0.02f), $"frame {frame}");
                Assert.That(tail.x, Is.Zero.Within(1e-6f));
                highest = Mathf.Max(highest, up);
                deepest = Mathf.Min(deepest, up);
            }

            Assert.That((highest, deepest), Is.EqualTo((swing, -swing)).Using<float>((a, b) => Math.Abs(a - b) < 0.3f * swing ? 0 : 1));
        }

        // Wings that are not flapped leave it where it rests, and so does one that is switched off.
        [UnityTest]
        public IEnumerator AtRest_ItHangsAsItWasPlaced()
        {
            AbdomenSwing abdomen = Monarch(out InsectWings wings);
            yield return Frames(10);
            Assert.That(Quaternion.Angle(abdomen.transform.localRotation, Quaternion.identity), Is.GreaterThan(0.1f));
            wings.Steering.amplitudeScale = 0f;
            yield return Frames(60);
            Assert.That(Quaternion.Angle(abdomen.transform.localRotation, Quaternion.identity), Is.LessThan(0.05f));
            wings.Steering.amplitudeScale = 1f;
            yield return Frames(60);
            abdomen.enabled = false;
            Assert.That(abdomen.transform.localRotation, Is.EqualTo(Quaternion.identity));
        }

        // A bone of another model: turned in its own way, below a parent that is turned too.
        [UnityTest]
        public IEnumerator ABone_TurnsAboutTheAxisOfItsParent_FromWhereItWasPlaced()
        {
            InsectWings wings = Insect();
            Transform parent = new GameObject("hip").transform, bone = new GameObject("abdomen").transform;
            parent.SetParent(wings.transform, false);
            bone.SetParent(parent, false);
            var placed = Quaternion.Euler(20f, 180f, 30f);
            bone.localRotation = placed;
            bone.gameObject.AddComponent<AbdomenSwing>().Swing = 30f;
            var turns = new List<Quaternion>();
            for (int frame = 0; frame < 30; frame++)
            {
                yield return null;
                turns.Add(bone.localRotation * Quaternion.Inverse(placed));
            }

            Assert.That(turns, Has.All.Matches<Quaternion>(turn => Mathf.Abs(turn.y) < 1e-5f && Mathf.Abs(turn.z) < 1e-5f));
            Assert.That(turns, Has.Some.Matches<Quaternion>(turn => Quaternion.Angle(turn, Quaternion.identity) > 20f));
        }

        [Test]
        public void ABoneWithoutWings_StaysAsItIs()
        {
            GameObject bone = Keep(new GameObject("abdomen"));
            bone.transform.localRotation = Quaternion.Euler(10f, 0f, 0f);
            AbdomenSwing swing = bone.AddComponent<AbdomenSwing>();
            swing.Swing = 90f;
            swing.LowestPhase = -10f;
            Assert.That((swing.Swing, swing.LowestPhase), Is.EqualTo((45f, 0f)), "in their ranges");
            swing.enabled = false;
            Assert.That(Quaternion.Angle(bone.transform.localRotation, Quaternion.Euler(10f, 0f, 0f)), Is.Zero.Within(1e-3f));
        }

        // A file may say a phase below zero.
        [Test]
        public void APhaseBelowZero_IsShownAsOneOfTheBeat()
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            IReadOnlyList<BodyEllipsoid> parts = monarch.FlightParts;
            try
            {
                monarch.FlightParts = parts.Select(part => part.swing == 0f ? part : part.Swinging(10f, -90f)).ToList();
                var made = InsectParts.Make(monarch);
                GameObject insect = Keep(made.Assemble(made.CreatePresets(InsectVariant.Standard, ModelReading.Physical)));
                Assert.That(insect.GetComponentInChildren<AbdomenSwing>(true).LowestPhase, Is.EqualTo(270f));
                UnityEngine.Object.DestroyImmediate(insect);
                made.Destroy();
            }
            finally
            {
                monarch.FlightParts = parts;
            }
        }

        private InsectWings Insect()
        {
            InsectWings wings = Keep(InsectFactory.Create(InsectCatalogue.Find("monarch")).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            return wings;
        }

        private AbdomenSwing Monarch(out InsectWings wings)
        {
            wings = Insect();
            AbdomenSwing abdomen = wings.GetComponentInChildren<AbdomenSwing>();
            Assert.That((abdomen.Swing, abdomen.LowestPhase), Is.EqualTo((13.8f, 42f)), "of the species");
            return abdomen;
        }
    }
}
