using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Poses of insects while the game does not play, as an Animation window or Timeline scrubs through them.</summary>
    public sealed class PosedInsectTests : PosedInsectFixture
    {
        [SetUp]
        public void BeginToListen() => BeatScrubbing.Clear();

        [TearDown]
        public void StopListening() => BeatScrubbing.Clear();

        [Test]
        public void OneBeat_HasOnePose_WhateverWasShownBefore()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            foreach (float beat in new[] { 0f, 0.3f, 0.62f })
            {
                Vector3[] first = At(posed, insect, beat);
                foreach (float other in new[] { 0.9f, -3.3f, 17.1f, 0.31f })
                    Assert.That(At(posed, insect, other), Is.Not.EqualTo(first));
                Assert.That(At(posed, insect, beat), Is.EqualTo(first), "to the bit");
                Assert.That(At(Pose(insect), insect, beat), Is.EqualTo(first), "of another one too");
                Vector3[] later = At(posed, insect, beat + 4f);
                Assert.That(first.Zip(later, Vector3.Distance).Max(), Is.LessThan(1e-3f), "a beat is a beat");
            }
        }

        [Test]
        public void Wings_AreUpAtTheTopOfTheStroke_AndDownHalfABeatLater()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Assert.That(Tip(At(posed, insect, 0f)), Is.GreaterThan(0.2f));
            Assert.That(Tip(At(posed, insect, 0.5f)), Is.LessThan(-0.1f));
        }

        [Test]
        public void TheStartPhase_IsWhereTheFirstBeatBegins()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Vector3[] quarter = At(posed, insect, 0.25f);
            insect.StartPhase = 90f;
            Assert.That(At(posed, insect, 0f).Zip(quarter, Vector3.Distance).Max(), Is.LessThan(1e-5f));
        }

        [Test]
        public void SteeringWindAndFold_AreSeen_AndASecondLookComputesNothing()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            var seen = new List<Vector3[]> { At(posed, insect, 0.3f) };
            insect.Steering.amplitudeScale = 0.5f;
            seen.Add(At(posed, insect, 0.3f));
            insect.Steering.tilt = 30f;
            seen.Add(At(posed, insect, 0.3f));
            insect.Wings[0].PhaseLead = 40f;
            seen.Add(At(posed, insect, 0.3f));
            insect.Air.wind = new Vector3(0f, 0f, -8f);
            seen.Add(At(posed, insect, 0.3f));
            insect.Steering.fold = 1f;
            seen.Add(At(posed, insect, 0.3f));
            for (int k = 1; k < seen.Count; k++)
                Assert.That(seen[k].Zip(seen[k - 1], Vector3.Distance).Max(), Is.GreaterThan(1e-3f), $"change {k}");
            Vector3[] still = At(posed, insect, 0.7f);
            Assert.That(still.Zip(seen[5], Vector3.Distance).Max(), Is.LessThan(0.02f), "folded wings do not beat");
            int poses = posed.PoseCount;
            At(posed, insect, 0.7f);
            Assert.That(posed.PoseCount, Is.EqualTo(poses));
        }

        [Test]
        public void NothingThatIsSaved_IsTouched_AndTheAuthoredMeshesComeBack()
        {
            InsectWings insect = Insect();
            Mesh[] meshes = insect.Wings.Select(MeshOf).ToArray();
            Vector3[] authored = meshes[0].vertices;
            Tick(insect);
            bool[] dirty = Dirty(insect);
            BeatScrubbing.Refresh();
            Assert.That(BeatScrubbing.All, Has.Count.EqualTo(1));
            Assert.That(insect.Wings.All(wing => wing.Renderer.forceRenderingOff), Is.True);
            Assert.That(insect.Wings.Select(MeshOf), Is.EqualTo(meshes));
            Assert.That(meshes[0].vertices, Is.EqualTo(authored));
            Assert.That(Dirty(insect), Is.EqualTo(dirty));
            PosedMesh posed = BeatScrubbing.All.First().Meshes[0];
            Assert.That(posed.Mesh.hideFlags, Is.EqualTo(HideFlags.HideAndDontSave));
            Assert.That(posed.Mesh.vertices, Is.Not.EqualTo(authored));

            insect.Preview.shows = false;
            BeatScrubbing.Refresh();
            Assert.That(BeatScrubbing.All, Is.Empty);
            Assert.That(insect.Wings.Any(wing => wing.Renderer.forceRenderingOff), Is.False);
            Assert.That(posed.Mesh == null, Is.True);
        }

        [Test]
        public void SeveralInsects_HaveTheirOwnPoses_AndTheInspectorStartsThem()
        {
            InsectWings one = Insect(), other = Insect();
            Tick(one, other);
            one.Preview.beat = 0.5f;
            BeatScrubbing.Refresh();
            IEnumerable<float> sides = BeatScrubbing.All.Select(posed => Mathf.Sign(Tip(posed.Meshes[0].Mesh.vertices)));
            Assert.That(sides, Is.EquivalentTo(new[] { -1f, 1f }));
            Object.DestroyImmediate(one.gameObject);
            BeatScrubbing.Refresh();
            Assert.That(BeatScrubbing.All, Has.Count.EqualTo(1));
        }

        [Test]
        public void WhatCannotLive_IsShownAsAuthored_UntilItIsMended()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Mesh mesh = MeshOf(insect.Wings[0]);
            Vector3[] shown = At(posed, insect, 0.2f);
            insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh = null;
            posed.Refresh();
            Assert.That(posed.Meshes, Is.Empty);
            Assert.That(insect.Wings[1].Renderer.forceRenderingOff, Is.False);
            insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh = mesh;
            posed.Refresh();
            Assert.That(posed.Meshes, Has.Count.EqualTo(2));
            insect.enabled = false;
            posed.Refresh();
            Assert.That(posed.Meshes, Is.Empty);
            insect.enabled = true;
            Assert.That(At(posed, insect, 0.2f), Is.EqualTo(shown), "the same pose, of a mesh that is new");
        }

        [Test]
        public void WhatIsNoBeat_IsTheStart([Values(float.NaN, float.PositiveInfinity, 1e30f)] float beat)
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Vector3[] start = At(posed, insect, 0f);
            insect.Air.wind = new Vector3(float.IsNaN(beat) ? beat : 0f, 0f, 0f);
            Vector3[] shown = At(posed, insect, beat);
            Assert.That(shown.All(place => !float.IsNaN(place.sqrMagnitude)), Is.True);
            Assert.That(float.IsNaN(beat) || shown.SequenceEqual(start), Is.True);
        }

        private static void Tick(params Object[] insects)
        {
            var fields = new SerializedObject(insects);
            fields.FindProperty("m_Preview.shows").boolValue = true;
            fields.ApplyModifiedPropertiesWithoutUndo();
        }

        private static bool[] Dirty(InsectWings insect) =>
            insect.Wings.Select(wing => EditorUtility.IsDirty(wing.Renderer)).Append(EditorUtility.IsDirty(insect)).ToArray();

        // The vertex that is farthest from the body, whichever wing it is.
        private static float Tip(Vector3[] vertices) => vertices.OrderByDescending(place => Mathf.Abs(place.x)).First().y;
    }
}
