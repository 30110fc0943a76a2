using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Skinned wings where something lacks: readable meshes, bind poses, a parent, or an active object.</summary>
    public sealed class SkinnedEdgeLaws : SkinnedWingFixture
    {
        // Names decide: the renderer's, the materials' of its submeshes, the bones'; a material beyond the last submesh is an overlay.
        [TestCase("Fly", "chest/a", "chitin", false)]
        [TestCase("Wings", "chest/a", "chitin", true)]
        [TestCase("Fly", "chest/wing_R", "chitin", true)]
        [TestCase("Fly", "chest/a", "wing", true)]
        [TestCase("Fly", "chest/a", "chitin chitin wing", false)]
        [TestCase("Fly", "chest/a", "chitin wing chitin", true)]
        [TestCase("elytra", "chest/wing_R", "wing", false)]
        public void OfAMeshThatCannotBeRead_NamesTellWhetherItHasWings(string name, string bone, string materials, bool hasWings)
        {
            m_Insect.Bone(bone);
            MeshSketch sketch = Body().NextSubmesh().Box(Vector3.up, Vector3.one);
            SkinnedMeshRenderer source = m_Insect.Skin(name, sketch, p => SkinnedSketch.One(0), materials.Split(' '));
            source.sharedMesh.UploadMeshData(true);
            Assert.That(SkinnedWings.IsIn(source, m_Insect.Root), Is.EqualTo(hasWings));
        }

        [Test]
        public void AMissingBone_NamesNothing()
        {
            SkinnedMeshRenderer source = Winged("Fly", Body(), p => SkinnedSketch.One(0));
            source.bones = new[] { null, m_Insect.Bones[0] };
            source.sharedMesh.UploadMeshData(true);
            Assert.That(SkinnedWings.IsIn(source, m_Insect.Root), Is.False);
        }

        [Test]
        public void BindPosesThatLack_AreRefused()
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));
            source.sharedMesh.bindposes = source.sharedMesh.bindposes.Take(2).ToArray();
            Assert.That(() => SkinnedWingConversion.Convert(source, m_Insect.Root),
                Throws.ArgumentException.With.Message.EqualTo("Mesh 'Mesh' has 2 bind poses, too few for bone 2."));
        }

        [Test]
        public void ABoneWithoutABindPose_PlacesNothing()
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(0));
            Matrix4x4[] binds = source.sharedMesh.bindposes;
            source.rootBone = m_Insect.Bones[1];
            source.sharedMesh.bindposes = binds.Take(1).ToArray();
            Assert.That(SkinnedPose.ToWorld(source), Is.EqualTo(m_Insect.Bones[0].localToWorldMatrix * binds[0]), "the first has one");
            source.bones = new[] { null, m_Insect.Bones[1] };
            Assert.That(SkinnedPose.ToWorld(source), Is.EqualTo(source.transform.localToWorldMatrix), "none has");
        }

        [Test]
        public void WithoutAParent_TheRendererIsTheInsect()
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));
            source.transform.SetParent(null, true);
            source.transform.SetPositionAndRotation(m_Insect.Root.position, m_Insect.Root.rotation);
            m_Result = SkinnedWingConversion.Convert(source);
            Assert.That(m_Result.Wings.Select(wing => wing.name), Is.EqualTo(new[] { "Wing Right", "Wing Left" }));
            source.transform.SetParent(m_Insect.Root, true);
        }

        [Test]
        public void WhatIsMade_IsNamedAfterItsMesh_AndAsActiveAsItsSource([Values] bool isActive)
        {
            SkinnedMeshRenderer source =
                Winged("Fly", Body().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f), Blended);
            source.gameObject.SetActive(isActive);
            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);
            Assert.That(m_Result.Wings.Select(wing => wing.gameObject.activeSelf), Is.EqualTo(new[] { isActive, isActive }));
            Assert.That(m_Result.WingMeshes.Select(mesh => mesh.name), Is.EqualTo(new[] { "Mesh Wing Right", "Mesh Wing Left" }));
            Assert.That(m_Result.BodyMesh.name, Is.EqualTo("Mesh Body"));
            foreach (MeshRenderer wing in m_Result.Wings)
                Assert.That((wing.transform.localPosition, wing.transform.localScale), Is.EqualTo((Vector3.zero, Vector3.one)));
        }

        [UnityTest]
        public IEnumerator Restore_GivesBackWhetherTheSourceWasOn([Values] bool wasOn, [Values] bool groupIsGone)
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));
            source.enabled = wasOn;
            LODGroup group = m_Insect.Root.gameObject.AddComponent<LODGroup>();
            group.SetLODs(new[] { new LOD(0.5f, new Renderer[] { source }) });
            m_Result = SkinnedWingConversion.Convert(source);
            Assert.That(m_Result.BodyMesh, Is.Null);
            Assert.That(source.enabled, Is.False, "its wings are drawn instead");
            Assert.That(m_Result.Wings.Select(wing => wing.enabled), Is.EqualTo(new[] { wasOn, wasOn }));
            if (groupIsGone)
                Object.DestroyImmediate(group);
            m_Result.Restore();
            yield return null;
            Assert.That(source.enabled, Is.EqualTo(wasOn));
            source.enabled = !wasOn;
            m_Result.Restore();
            Assert.That(source.enabled, Is.EqualTo(!wasOn), "a second call does nothing");
        }
    }
}
