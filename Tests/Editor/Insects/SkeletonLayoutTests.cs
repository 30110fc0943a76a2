using System;
using System.Linq;
using Alate.Fitting;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>The button that lays out skeletons, saves and assigns them.</summary>
    public sealed class SkeletonLayoutTests : InsectFixture
    {
        private static readonly InsectProblem s_All = InsectProblem.None;

        // The body is a hint: a wing that is drawn by a turned object has the chains of one that is not, where it is drawn.
        [TestCase(0f, 0f, 0f)]
        [TestCase(0f, 130f, 0f)]
        [TestCase(70f, -40f, 160f)]
        public void AFit_HasItsChainsWhereTheWingIsDrawn_HoweverItsObjectIsTurned(float x, float y, float z)
        {
            GameObject bare = Bare();
            bare.transform.SetPositionAndRotation(new Vector3(3f, 4f, 5f), Quaternion.Euler(10f, 200f, 30f));
            Transform wing = bare.GetComponentsInChildren<MeshRenderer>()[0].transform;
            var surface = SurfaceMesh.FromMesh(wing.GetComponent<MeshFilter>().sharedMesh);
            WingSkeleton plain = Keep(LayOutSkeletonFix.Fit(surface, bare.transform, wing).Skeleton);
            var turn = Quaternion.Euler(x, y, z);
            wing.localRotation = turn;
            surface.positions = Array.ConvertAll(surface.positions, place => Quaternion.Inverse(turn) * place);
            surface.normals = null;
            WingSkeleton turned = Keep(LayOutSkeletonFix.Fit(surface, bare.transform, wing).Skeleton);

            float length = (plain.GetJoint(0, 4) - plain.GetJoint(0, 0)).magnitude;
            Assert.That((turn * turned.UpAxis - plain.UpAxis).magnitude, Is.LessThan(1e-3f), "up");
            for (int chain = 0; chain < 5; chain++)
            {
                for (int joint = 0; joint < 5; joint++)
                {
                    Assert.That((turn * turned.GetJoint(chain, joint) - plain.GetJoint(chain, joint)).magnitude,
                        Is.LessThan(0.01f * length), $"joint {chain}, {joint}");
                }
            }
        }

        [Test]
        public void WingsWithoutSkeleton_GetSavedOnes_AndUndoTakesThemOff()
        {
            InsectWings insect = Bones(out string path);

            FixOutcome outcome = LayOut(insect, path, s_All);

            Assert.That(outcome.IsDone, Is.True, outcome.Message);
            foreach (Wing wing in insect.Wings)
            {
                Assert.That(wing.Skeleton.IsValid, Is.True);
                Assert.That(AssetDatabase.Contains(wing.Skeleton), Is.True);
            }

            Assert.That(insect.Wings[0].Skeleton, Is.Not.SameAs(insect.Wings[1].Skeleton));
            Assert.That(insect.Wings[1].Skeleton.name, Does.EndWith("Left"));
            Undo.PerformUndo();
            Assert.That(insect.Wings.All(wing => wing.Skeleton == null), Is.True);
        }

        [Test]
        public void WingsOfOneMesh_ShareASkeleton()
        {
            InsectWings insect = Bones(out string path);
            insect.Wings[1].Renderer.GetComponent<MeshFilter>().sharedMesh = MeshOf(insect.Wings[0]);
            insect.Wings[1].Renderer.transform.localScale = new Vector3(-1f, 1f, 1f);

            LayOut(insect, path, s_All);

            Assert.That(insect.Wings[0].Skeleton, Is.Not.Null);
            Assert.That(insect.Wings[1].Skeleton, Is.SameAs(insect.Wings[0].Skeleton));
            Assert.That(AssetDatabase.GetAssetPath(insect.Wings[0].Skeleton), Is.EqualTo(path));
        }

        [Test]
        public void OtherWings_KeepTheirSkeletons()
        {
            InsectWings insect = Insect();
            WingSkeleton kept = insect.Wings[0].Skeleton;
            insect.Wings[1].Skeleton = null;
            string path = PathFor("One Skeleton");

            LayOut(insect, path, s_All);

            Assert.That(insect.Wings[0].Skeleton, Is.SameAs(kept));
            Assert.That(AssetDatabase.GetAssetPath(insect.Wings[1].Skeleton), Is.EqualTo(path));
        }

        [Test]
        public void WingWithTheProblem_GetsANewOne_ThoughItHasOne()
        {
            InsectWings insect = Insect();
            WingSkeleton old = insect.Wings[1].Skeleton, other = insect.Wings[0].Skeleton;

            LayOut(insect, PathFor("New Skeleton"), new InsectProblem(InsectState.SkeletonDoesNotFit, 1, ""));

            Assert.That(insect.Wings[1].Skeleton, Is.Not.SameAs(old));
            Assert.That(insect.Wings[0].Skeleton, Is.SameAs(other));
        }

        [Test]
        public void WhatCannotBeLaidOut_IsSaid_AndNobodyIsAskedForAPlace()
        {
            InsectWings insect = Bones(out _);
            FitSkeleton never =
                (SurfaceMesh surface, Transform root, Transform mesh) => throw new ArgumentException("It is a ball.", nameof(mesh));
            var fix = new LayOutSkeletonFix(never, (_, __, ___) => throw new InvalidOperationException("asked"));

            FixOutcome outcome = fix.Apply(insect, s_All);

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Is.EqualTo("Wing 0: It is a ball. Wing 1: It is a ball."));
        }

        [TestCase(null)]
        [TestCase("Packages/x/y.asset")]
        public void WithoutAPlace_NothingIsAssignedOrLeftBehind(string path)
        {
            InsectWings insect = Bones(out _);
            WingSkeleton made = null;
            FitSkeleton noted = (SurfaceMesh surface, Transform root, Transform mesh) =>
            {
                SkeletonFit fit = LayOutSkeletonFix.Fit(surface, root, mesh);
                made = fit.Skeleton;
                return fit;
            };

            new LayOutSkeletonFix(noted, (_, __, ___) => path).Apply(insect, s_All);

            Assert.That(made == null, Is.True, "the skeleton was left behind");
            Assert.That(ReferenceEquals(made, null), Is.False, "no skeleton was laid out");
            Assert.That(insect.Wings.All(wing => wing.Skeleton == null), Is.True);
        }

        [Test]
        public void ThePlace_IsAskedForUnderATitle_WithANameForTheInsectsFile_AndAReason()
        {
            InsectWings insect = Bones(out _);
            insect.name = "Moth";
            (string title, string name, string reason) asked = default;
            new LayOutSkeletonFix(LayOutSkeletonFix.Fit, (title, name, reason) =>
            {
                asked = (title, name, reason);
                return "";
            }).Apply(insect, s_All);

            Assert.That(asked.title, Is.EqualTo("Save Wing Skeleton"));
            Assert.That(asked.name, Is.EqualTo("Moth Skeleton"));
            Assert.That(asked.reason, Does.Contain("where the new skeleton is saved"));
        }

        [Test]
        public void WhereAllHaveSkeletons_NothingIsDone()
        {
            FixOutcome outcome = LayOut(Insect(), "Assets/x.asset", s_All);

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Does.Contain("All wings"));
        }

        [Test]
        public void SavedSkeletons_AreNoLongerTheLayouts()
        {
            InsectWings insect = Bones(out string path);
            var layout = SkeletonLayout.Of(insect, new[] { 0, 1 }, LayOutSkeletonFix.Fit);
            Assert.That(layout.Count, Is.EqualTo(2));
            WingSkeleton[] saved = layout.Save(path, "Lay Out").OrderBy(wing => wing.Key).Select(wing => wing.Value).ToArray();
            Assert.That(layout.Count, Is.Zero);
            layout.Dispose();

            Assert.That(saved.Select(skeleton => skeleton != null && skeleton.IsValid), Is.EqualTo(new[] { true, true }));
        }

        private static FixOutcome LayOut(InsectWings insect, string path, in InsectProblem problem) =>
            new LayOutSkeletonFix(LayOutSkeletonFix.Fit, (_, __, ___) => path).Apply(insect, problem);

        private InsectWings Bones(out string path)
        {
            InsectWings insect = Insect();
            foreach (Wing wing in insect.Wings)
                wing.Skeleton = null;
            PathFor("Skeleton Right");
            PathFor("Skeleton Left");
            path = PathFor("Skeleton");
            return insect;
        }
    }
}
