using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of poses in edit mode: what turns with its wind stays as it is, and what a rig depends on makes a new one.</summary>
    public sealed class PosedInsectLaws : PosedInsectFixture
    {
        private Vector3 m_Gravity;

        [SetUp]
        public void KeepGravity() => m_Gravity = Physics.gravity;

        [TearDown]
        public void ResetGravity() => Physics.gravity = m_Gravity;

        [Test]
        public void TurnedWithItsWind_APoseIsTheSame_AndInTheWindAloneIsNot()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            insect.Air.wind = new Vector3(0.4f, 0.2f, -2f);
            Vector3[] before = At(posed, insect, 0.4f);
            insect.transform.rotation = Quaternion.Euler(0f, 70f, 0f);
            Assert.That(Apart(At(posed, insect, 0.4f), before), Is.GreaterThan(5e-4f), "the wind comes from elsewhere");
            insect.Air.wind = Quaternion.Euler(0f, 70f, 0f) * insect.Air.wind;
            Assert.That(Apart(At(posed, insect, 0.4f), before), Is.LessThan(1e-4f));
            insect.transform.position += new Vector3(30f, 10f, -20f);
            Assert.That(Apart(At(posed, insect, 0.4f), before), Is.LessThan(1e-4f), "wherever it is");
        }

        [Test]
        public void TurnedWithGravity_APoseIsTheSame()
        {
            InsectWings insect = Shown();
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            PosedInsect posed = Pose(insect);
            Physics.gravity = new Vector3(0f, -300f, 0f);
            Vector3[] before = At(posed, insect, 0.6f);
            Physics.gravity = new Vector3(0f, 0f, -300f);
            Assert.That(Apart(At(posed, insect, 0.6f), before), Is.GreaterThan(1e-4f));
            insect.transform.rotation = Quaternion.FromToRotation(Vector3.down, Vector3.back);
            Assert.That(Apart(At(posed, insect, 0.6f), before), Is.LessThan(1e-4f));
        }

        [Test]
        public void MetresPerUnit_ScaleTheWind()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            insect.Motion.metresPerUnit = 1f;
            insect.Air.wind = new Vector3(0f, 0.3f, -1.5f);
            Vector3[] before = At(posed, insect, 0.4f);
            insect.Motion.metresPerUnit = 0.25f;
            Assert.That(Apart(At(posed, insect, 0.4f), before), Is.GreaterThan(1e-4f));
            insect.Air.wind *= 4f;
            Assert.That(Apart(At(posed, insect, 0.4f), before), Is.LessThan(1e-5f));
        }

        [Test]
        public void AWindThatIsNone_OrBeyondTheWorld_IsLeftOut()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            insect.Air.wind = new Vector3(0f, 0f, -3f);
            Vector3[] windy = At(posed, insect, 0.4f);
            insect.Air.wind = new Vector3(0f, float.NaN, 0f);
            Vector3[] none = At(posed, insect, 0.4f);
            foreach (Vector3 wind in new[] { new Vector3(0f, 0f, -2e7f), new Vector3(1.1e7f, 0f, 0f), new Vector3(0f, 1e20f, 0f) })
            {
                insect.Air.wind = wind;
                Assert.That(At(posed, insect, 0.4f), Is.EqualTo(none), $"{wind}");
            }

            Assert.That(Apart(windy, none), Is.GreaterThan(1e-3f));
            insect.Air.wind = new Vector3(0f, 0f, -0.9e7f);
            Assert.That(At(posed, insect, 0.4f), Is.Not.EqualTo(none), "within the world it counts, as far as the wing bears it");
        }

        // An animation writes fields past their limits.
        [TestCase(450f, 360f)]
        [TestCase(-90f, 0f)]
        [TestCase(float.NaN, 0f)]
        [TestCase(359f, 359f)]
        public void AStartPhaseBeyondItsRange_IsItsEnd(float written, float end)
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            FieldInfo field = typeof(InsectWings).GetField("m_StartPhase", BindingFlags.Instance | BindingFlags.NonPublic);
            field.SetValue(insect, written);
            Vector3[] shown = At(posed, insect, 0.2f);
            field.SetValue(insect, 0f);
            Assert.That(Apart(shown, At(posed, insect, 0.2f + end / 360f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void AWingsOwnPreset_MovesThatWingAlone_AndTheInsectsTheOthers()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Vector3[] first = At(posed, insect, 0.1f), second = posed.Meshes[1].Mesh.vertices;
            insect.Wings[0].Preset = Flat(0.5f);
            Assert.That(Apart(At(posed, insect, 0.1f), first), Is.GreaterThan(0.01f));
            Assert.That(Apart(posed.Meshes[1].Mesh.vertices, second), Is.LessThan(1e-6f));
            Vector3[] own = posed.Meshes[0].Mesh.vertices;
            insect.Preset = Flat(0.25f);
            Assert.That(Apart(At(posed, insect, 0.1f), own), Is.LessThan(1e-6f));
            Assert.That(Apart(posed.Meshes[1].Mesh.vertices, second), Is.GreaterThan(0.01f));
        }

        [Test]
        public void WhatARigDependsOn_MakesANewOne_AndWhatItDoesNot_KeepsIt()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            At(posed, insect, 0.1f);
            Wing wing = insect.Wings[0];
            WingSkeleton skeleton = wing.Skeleton;
            MeshFilter filter = wing.Renderer.GetComponent<MeshFilter>();
            (string what, bool isNew, Action act)[] acts =
            {
                ("patches", true, () => insect.Quality.patches = 40),
                ("submesh", true, () => wing.Submesh = 3),
                ("point", true, () => wing.Point = Vector3.one),
                ("part", true, () => (wing.Submesh, wing.Part) = (0, WingPart.Submesh)),
                ("a joint", true, () => skeleton.Chains[2].joints[4] += 0.01f * Vector3.forward),
                ("no skeleton", true, () => wing.Skeleton = null),
                ("its skeleton", true, () => wing.Skeleton = skeleton),
                ("another mesh", true, () => filter.sharedMesh = Keep(UnityEngine.Object.Instantiate(filter.sharedMesh))),
                ("side", false, () => wing.PhaseLead = 20f),
                ("steering", false, () => insect.Steering.amplitudeScale = 0.7f),
            };
            foreach ((string what, bool isNew, Action act) in acts)
            {
                int poses = posed.PoseCount;
                Mesh before = posed.Meshes[0].Mesh;
                act();
                posed.Refresh();
                Assert.That(posed.PoseCount, Is.EqualTo(poses + 1), what);
                Assert.That(before == null, Is.EqualTo(isNew), what);
                posed.Refresh();
                Assert.That(posed.PoseCount, Is.EqualTo(poses + 1), what + ", looked at again");
            }
        }

        [Test]
        public void EachThingThatAPoseDependsOn_IsLookedAt_OfEachWing()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            At(posed, insect, 0.1f);
            var acts = new List<Action>
            {
                () => insect.Preview.beat = 0.11f,
                () => insect.StartPhase = 1f,
                () => insect.Wings[1].AmplitudeScale = 0.9f,
                () => insect.Air.wind = new Vector3(0f, 0f, -1f),
                () => Physics.gravity *= 2f,
                () => insect.Steering.fold = 0.5f,
                () => insect.Steering.fold = 0.6f,
                () => (insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>())).Beat.flapRange = 50f,
                () => insect.transform.rotation = Quaternion.Euler(30f, 0f, 0f),
            };
            for (int k = 0; k < acts.Count; k++)
            {
                int poses = posed.PoseCount;
                acts[k]();
                posed.Refresh();
                Assert.That(posed.PoseCount, Is.EqualTo(poses + 1), $"change {k}");
            }
        }

        [Test]
        public void APosedMesh_HoldsItsVertices_WithNormalsOfOneUnit_ThatMoveWithThem()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            At(posed, insect, 0f);
            Mesh mesh = posed.Meshes[0].Mesh, authored = MeshOf(insect.Wings[0]);
            Vector3[] normals = mesh.normals;
            Assert.That(normals, Has.Length.EqualTo(mesh.vertexCount));
            Assert.That(normals, Is.All.Matches<Vector3>(normal => Mathf.Abs(normal.magnitude - 1f) < 1e-2f));
            Assert.That(Apart(normals, authored.normals), Is.GreaterThan(0.1f));
            Bounds bounds = mesh.bounds;
            var tight = new Bounds(mesh.vertices[0], Vector3.zero);
            foreach (Vector3 place in mesh.vertices)
                tight.Encapsulate(place);
            Assert.That((bounds.min - tight.min).magnitude + (bounds.max - tight.max).magnitude, Is.LessThan(1e-4f));
            Assert.That(mesh.name, Is.EqualTo(authored.name + " (preview)"));
            Assert.That(mesh.triangles, Is.EqualTo(authored.triangles));
        }

        [Test]
        public void ARendererThatWasOff_StaysOff_AndAfterwardsNothingIsPosed()
        {
            InsectWings insect = Shown();
            insect.Wings[0].Renderer.forceRenderingOff = true;
            PosedInsect posed = Pose(insect);
            At(posed, insect, 0f);
            Assert.That(insect.Wings.Select(wing => wing.Renderer.forceRenderingOff), Is.EqualTo(new[] { true, true }));
            posed.Dispose();
            Assert.That(insect.Wings.Select(wing => wing.Renderer.forceRenderingOff), Is.EqualTo(new[] { true, false }));
            Assert.That(posed.Meshes, Is.Empty);
        }

        [Test]
        public void AMeshWithoutNormals_IsPosedToo()
        {
            InsectWings insect = Shown();
            PosedInsect posed = Pose(insect);
            Vector3[] with = At(posed, insect, 0.3f);
            Mesh bare = Keep(UnityEngine.Object.Instantiate(MeshOf(insect.Wings[0])));
            bare.normals = null;
            insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh = bare;
            Assert.That(Apart(At(posed, insect, 0.3f), with), Is.LessThan(1e-5f));
            Assert.That(posed.Meshes[0].Mesh.normals, Is.Empty);
        }

        private WingPreset Flat(float share)
        {
            WingPreset preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            preset.Beat.flapRange *= share;
            return preset;
        }

        private static float Apart(Vector3[] one, Vector3[] other) => one.Zip(other, Vector3.Distance).Max();
    }
}
