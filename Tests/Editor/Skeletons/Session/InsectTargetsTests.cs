using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Fitting;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class InsectTargetsTests : SkeletonSessionFixture
    {
        [Test]
        public void EveryWing_IsFound_WithItsMeshAndItsPlace()
        {
            List<SkeletonTarget> targets = Find();

            Assert.That(targets.Select(t => t.Skeleton), Is.EqualTo(new[] { Right.Skeleton, Left.Skeleton }));
            Assert.That(targets[0].HasSurface);
            Assert.That(targets[0].Surface.triangles.Length / 3, Is.EqualTo(InsectCatalogue.Find("monarch").Wings[0].TriangleCount));
            Assert.That(targets[0].LocalToWorld, Is.EqualTo(Right.Renderer.transform.localToWorldMatrix));
        }

        [Test]
        public void WingsOfBothSides_AreEachOthersTwins_AcrossTheInsect()
        {
            List<SkeletonTarget> targets = Find();

            Assert.That(targets[0].OtherSide, Is.SameAs(targets[1]));
            Assert.That(targets[1].OtherSide, Is.SameAs(targets[0]));
            MirrorTests.AssertMirrored(Left.Skeleton, Right.Skeleton, targets[0].MakeTwin().ToTwin);
            MirrorTests.AssertMirrored(Right.Skeleton, Left.Skeleton, targets[1].MakeTwin().ToTwin);
        }

        [Test]
        public void TwinsFollow_WhereTheMeshHasASpaceOfItsOwn()
        {
            // The left mesh is turned and half as large in its own space; its object makes up for that.
            var own = Matrix4x4.TRS(new Vector3(0.1f, 0.2f, 0.3f), Quaternion.Euler(0f, 90f, 0f), 0.5f * Vector3.one);
            Transform place = Left.Renderer.transform;
            Matrix4x4 drawn = Insect.transform.worldToLocalMatrix * place.localToWorldMatrix * own.inverse;
            place.localPosition = drawn.GetPosition();
            place.localRotation = drawn.rotation;
            place.localScale = drawn.lossyScale;
            SkeletonDraft.Read(Left.Skeleton, out SkeletonDraft draft);
            SkeletonMirror.Reflect(draft, own).WriteTo(Left.Skeleton);

            MirrorTests.AssertMirrored(Left.Skeleton, Right.Skeleton, Find()[0].MakeTwin().ToTwin);
        }

        [Test]
        public void SkeletonSharedByBothSides_IsFoundOnce_AndHasNoTwin()
        {
            Left.Skeleton = Right.Skeleton;

            SkeletonTarget target = Find().Single();

            Assert.That(target.MakeTwin(), Is.Null);
        }

        [Test]
        public void HindWings_AreNotTwinsOfForeWings()
        {
            Left.Pair = WingPair.Hind;

            Assert.That(Find()[0].OtherSide, Is.Null);
        }

        [Test]
        public void WingsOwnPreset_GoesBeforeTheInsects()
        {
            Insect.Preset = Keep(InsectCatalogue.Monarch());
            Left.Preset = Keep(InsectCatalogue.Monarch());

            List<SkeletonTarget> targets = Find();

            Assert.That(targets[0].Preset, Is.SameAs(Insect.Preset));
            Assert.That(targets[1].Preset, Is.SameAs(Left.Preset));
        }

        [Test]
        public void WingsThatLackSomething_AreLeftOut_OrLackAMesh()
        {
            Right.Renderer.GetComponent<MeshFilter>().sharedMesh = null;
            Left.Skeleton = null;
            Insect.Wings.Add(null);
            Insect.Wings.Add(new Wing());

            SkeletonTarget target = Find().Single();

            Assert.That(target.HasSurface, Is.False);
            Assert.That(InsectTargets.SurfaceOf(Right, out string refusal), Is.Null);
            Assert.That(refusal, Is.EqualTo("The wing has no mesh."));
            Assert.That(InsectTargets.WithoutSkeleton(Insect), Is.EqualTo(new[] { Left }));
        }

        [Test]
        public void Stamp_ChangesWithTheWings_ButNotWithTheirPlaceOrContent()
        {
            int before = InsectTargets.StampOf(new[] { Insect });
            Insect.transform.position = Vector3.one;
            Right.Skeleton.Hinge = Vector3.one;
            Assert.That(InsectTargets.StampOf(new[] { Insect }), Is.EqualTo(before));

            Insect.Preset = Keep(InsectCatalogue.Monarch());
            Assert.That(InsectTargets.StampOf(new[] { Insect }), Is.Not.EqualTo(before));
            Insect.Preset = null;

            WingSkeleton skeleton = Left.Skeleton;
            Left.Skeleton = null;
            int without = InsectTargets.StampOf(new[] { Insect });
            Assert.That(without, Is.Not.EqualTo(before));
            Left.Skeleton = skeleton;
            Left.Side = WingSide.Right;
            Assert.That(InsectTargets.StampOf(new[] { Insect }), Is.Not.EqualTo(before).And.Not.EqualTo(without));
        }

        [Test]
        public void WhatIsKnown_IsHowTheInsectLies_InTheWingsSpace()
        {
            Left.Renderer.transform.localRotation = Quaternion.Euler(10f, 40f, -25f);
            SkeletonFitSettings known = Find()[1].Known();

            Transform place = Left.Renderer.transform;
            Assert.That(Vector3.Distance(place.TransformPoint(known.bodyPoint.Value), Insect.transform.position), Is.LessThan(1e-4f));
            Assert.That(Vector3.Angle(place.TransformVector(known.forward.Value), Insect.transform.forward), Is.LessThan(0.05f));
            Assert.That(Vector3.Angle(place.TransformVector(known.up.Value), Insect.transform.up), Is.LessThan(0.05f));
        }

        [Test]
        public void PartOfAMesh_IsTakenOutOfIt()
        {
            Mesh mesh = Right.Renderer.GetComponent<MeshFilter>().sharedMesh;
            int[] all = mesh.triangles;
            mesh.subMeshCount = 2;
            mesh.SetTriangles(all.Take(300).ToArray(), 0);
            mesh.SetTriangles(all.Skip(300).ToArray(), 1);
            Right.Part = WingPart.Submesh;
            Right.Submesh = 1;

            Assert.That(Find()[0].Surface.triangles.Length, Is.EqualTo(all.Length - 300));

            Right.Submesh = 7;
            Assert.That(InsectTargets.SurfaceOf(Right, out string refusal), Is.Null);
            Assert.That(refusal, Does.Contain("has no submesh 7"));
        }

        private List<SkeletonTarget> Find() => InsectTargets.Find(new[] { Insect });
    }
}
