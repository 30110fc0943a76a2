using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class SkinnedWingConversionTests : SkinnedWingFixture
    {
        [Test]
        public void ARendererThatIsAllWing_BecomesOneUnderItsBone_AndFollowsIt([Values(0, 1, 2)] int pose)
        {
            m_Insect.Bone("chest/hinge", new Vector3(0.1f, 0f, 0f));
            SkinnedMeshRenderer source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            MoveOnce(pose);
            Vector3[] before = m_Insect.Posed(source.sharedMesh);

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(source.enabled, Is.False);
            Assert.That(m_Result.BodyMesh, Is.Null);
            Assert.That(m_Result.Wings.Single().transform.parent, Is.SameAs(m_Insect.Bones[1]));
            AssertDrawn(m_Result.Wings[0], before);
            m_Insect.Move(7);
            AssertDrawn(m_Result.Wings[0], m_Insect.Posed(source.sharedMesh));
        }

        [Test]
        public void BothWingsOfARenderer_FollowTheirOwnBones()
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));

            m_Result = SkinnedWingConversion.Convert(source);
            m_Insect.Move(3);

            Assert.That(m_Result.Wings.Select(wing => wing.name), Is.EqualTo(new[] { "Wing Right", "Wing Left" }));
            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(m_Insect.Bones.Skip(1)));
            foreach (MeshRenderer wing in m_Result.Wings)
                AssertDrawn(wing, m_Insect.Posed(source.sharedMesh));
        }

        [Test]
        public void WingsThatGrowOutOfTheBody_AreCutOff_WhereTheirBonesTakeOver()
        {
            // One connected mesh, from the left tip to the right; weights blend from the chest to the wings.
            MeshSketch sketch = new MeshSketch().Sheet(new Vector3(-1f, 0.1f, 0f), 2f * Vector3.right, 0.4f * Vector3.back, 40, 4);
            SkinnedMeshRenderer source = Winged("Butterfly", sketch, Blended);
            Mesh original = source.sharedMesh;
            Vector3[] bind = m_Insect.Posed(original);

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(source.enabled && source.sharedMesh == m_Result.BodyMesh);
            Assert.That(m_Result.Wings, Has.Count.EqualTo(2));
            Assert.That(TriangleCount(), Is.EqualTo(original.triangles.Length));
            foreach (MeshRenderer wing in m_Result.Wings)
                AssertDrawn(wing, bind);
            m_Insect.Move(11);
            Vector3[] posed = m_Insect.Posed(original);
            Assert.That(m_Insect.Posed(m_Result.BodyMesh), Is.EqualTo(posed));
            foreach (MeshRenderer wing in m_Result.Wings)
                AssertDrawn(wing, posed, number => Mathf.Abs(original.vertices[number].x) > 0.3f);
        }

        [Test]
        public void OfOneMeshWithTheBody_WingsAreFoundByMaterial_AndTheRestStaysSkinned()
        {
            MeshSketch sketch = Body().NextSubmesh().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f);
            SkinnedMeshRenderer source = Skinned("Fly", sketch, Blended, "chitin", "wing");
            Mesh original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);

            Assert.That(m_Result.BodyMesh.subMeshCount, Is.EqualTo(2));
            Assert.That(m_Result.BodyMesh.GetTriangles(0), Is.EqualTo(original.GetTriangles(0)));
            Assert.That(m_Result.BodyMesh.GetTriangles(1), Is.Empty);
            Assert.That(m_Result.BodyMesh.boneWeights, Is.EqualTo(original.boneWeights));
            Assert.That(m_Result.Wings.Select(wing => wing.sharedMaterial), Is.All.SameAs(source.sharedMaterials[1]));
            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(m_Insect.Bones.Skip(1)));
        }

        [Test]
        public void WhereNothingIsCalledAWing_ThinMirroredPartsAreWings()
        {
            SkinnedMeshRenderer source = Skinned("Fly", Body().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f), Blended);

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);

            Assert.That(m_Result.Wings.Select(wing => wing.name), Is.EqualTo(new[] { "Wing Right", "Wing Left" }));
            Assert.That(m_Result.BodyMesh.triangles, Has.Length.EqualTo(36));
        }

        [Test]
        public void APartThatIsAskedFor_IsTaken_WhateverItIsCalled()
        {
            SkinnedMeshRenderer source = Skinned("Fly", Body().NextSubmesh().Wing(Hinge(1f), 1f, 0.5f), p => SkinnedSketch.One(0));
            Mesh original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root, WingPart.Submesh, 1);
            Assert.That(m_Result.WingMeshes.Single().triangles, Has.Length.EqualTo(original.GetTriangles(1).Length));
            m_Result.Restore();
            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root, WingPart.ConnectedPart, 0, new Vector3(1f, 0.1f, 0f));
            Assert.That(m_Result.WingMeshes.Single().triangles, Has.Length.EqualTo(original.GetTriangles(1).Length));
        }

        [Test]
        public void SeveralBonesOfAWing_HangFromItsFirst_WhichCarriesIt()
        {
            m_Insect.Bone("chest/wing.R", Hinge(1f));
            m_Insect.Bone("chest/wing.R/wing.R.001", 0.2f * Vector3.right);
            m_Insect.Bone("chest/wing.R/wing.R.001/Bone", 0.2f * Vector3.right);
            m_Insect.Bone("chest/wing.L", Hinge(-1f));
            BoneWeight Right(Vector3 p) => SkinnedSketch.Two(1, p.x > 0.6f ? 3 : 2, 0.9f);
            SkinnedMeshRenderer source = m_Insect.Skin("Wings", Wings(), p => p.x < 0f ? SkinnedSketch.One(4) : Right(p));

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent.name), Is.EqualTo(new[] { "wing.R", "wing.L" }));
        }

        [Test]
        public void ForeAndHindWingsThatHangTogether_AreToldByTheirBones()
        {
            var sketch = new MeshSketch();
            foreach (float side in new[] { 1f, -1f })
                sketch.Wing(Hinge(side), side, 0.4f, 8, 8).Wing(Hinge(side) - new Vector3(0f, 0f, 0.4f), 0.8f * side, 0.3f, 8, 8);
            foreach (string name in new[] { "forewing_r", "hindwing_r", "forewing_l", "hindwing_l" })
                m_Insect.Bone("chest/" + name, Hinge(name.EndsWith("r") ? 1f : -1f));
            SkinnedMeshRenderer source = m_Insect.Skin(
                "Wings", sketch, p => SkinnedSketch.One((p.x > 0f ? 1 : 3) + (p.z < Hinge(1f).z - 0.4f ? 1 : 0)));

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(
                m_Result.Wings.Select(wing => $"{wing.name}: {wing.transform.parent.name}"),
                Is.EqualTo(new[]
                {
                    "Fore Wing Right: forewing_r", "Fore Wing Left: forewing_l",
                    "Hind Wing Right: hindwing_r", "Hind Wing Left: hindwing_l",
                }));
            Assert.That(TriangleCount(), Is.EqualTo(source.sharedMesh.triangles.Length));
        }

        [Test]
        public void WhatCannotBeConverted_IsRefused_AndNothingIsMade()
        {
            Refuses<ArgumentNullException>(null, "source");
            SkinnedMeshRenderer source = Skinned("Fly", Body(), p => SkinnedSketch.One(0));
            Refuses<ArgumentException>(source, "Nothing in 'Fly' looks like a wing");

            source.name = "Wing";
            source.bones = new Transform[2];
            Refuses<ArgumentException>(source, "Bone 0 of 'Wing', which carries a wing, is missing.");
            source.bones = new Transform[0];
            Refuses<ArgumentException>(source, "'Wing' has no bones: turn off Optimize Game Objects");
            source.sharedMesh.UploadMeshData(true);
            Refuses<ArgumentException>(source, "Mesh 'Mesh' is not readable");
            source.sharedMesh = null;
            Refuses<ArgumentException>(source, "'Wing' has no mesh.");
            Assert.That(m_Insect.Root.GetComponentsInChildren<MeshRenderer>(true), Is.Empty);
        }

        private void Refuses<T>(SkinnedMeshRenderer source, string message) where T : ArgumentException
        {
            Assert.That(() => SkinnedWingConversion.Convert(source, m_Insect.Root), Throws.InstanceOf<T>().With.Message.Contains(message));
        }

        private void MoveOnce(int pose)
        {
            if (pose > 0)
                m_Insect.Move(pose);
        }
    }
}
