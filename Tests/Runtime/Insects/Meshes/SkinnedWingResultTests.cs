using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    public sealed class SkinnedWingResultTests
    {
        private SkinnedSketch m_Insect;
        private SkinnedMeshRenderer m_Source;
        private SkinnedWingResult m_Result;

        [SetUp]
        public void MakeAFly()
        {
            m_Insect = new SkinnedSketch();
            m_Insect.Bone("chest");
            m_Insect.Bone("chest/wing_R", new Vector3(0.1f, 0.1f, 0f));
            m_Insect.Bone("chest/wing_L", new Vector3(-0.1f, 0.1f, 0f));
            MeshSketch sketch = new MeshSketch().Box(Vector3.zero, new Vector3(0.1f, 0.2f, 1f));
            foreach (float side in new[] { 1f, -1f })
                sketch.NextSubmesh().Wing(new Vector3(0.1f * side, 0.2f, 0.2f), side, 0.5f);
            m_Source = m_Insect.Skin("Fly", sketch, Weights, "chitin", "membrane", "glass", "glow");
        }

        [TearDown]
        public void EndIt()
        {
            m_Result?.Restore();
            m_Insect.Dispose();
        }

        [Test]
        public void HowItIsDrawn_IsKept()
        {
            Transform anchor = m_Insect.Bones[0];
            m_Source.gameObject.layer = 5;
            m_Source.gameObject.tag = "EditorOnly";
            m_Source.shadowCastingMode = ShadowCastingMode.TwoSided;
            m_Source.receiveShadows = false;
            m_Source.lightProbeUsage = LightProbeUsage.Off;
            m_Source.reflectionProbeUsage = ReflectionProbeUsage.Simple;
            m_Source.probeAnchor = anchor;
            m_Source.motionVectorGenerationMode = MotionVectorGenerationMode.Camera;
            m_Source.allowOcclusionWhenDynamic = false;
            m_Source.renderingLayerMask = 6;
            m_Source.rendererPriority = 3;
            m_Source.sortingOrder = -4;

            Convert();

            foreach (MeshRenderer wing in m_Result.Wings)
            {
                Assert.That((wing.gameObject.layer, wing.tag, wing.enabled), Is.EqualTo((5, "EditorOnly", true)));
                Assert.That((wing.shadowCastingMode, wing.receiveShadows), Is.EqualTo((ShadowCastingMode.TwoSided, false)));
                Assert.That(wing.lightProbeUsage, Is.EqualTo(LightProbeUsage.Off));
                Assert.That(wing.reflectionProbeUsage, Is.EqualTo(ReflectionProbeUsage.Simple));
                Assert.That(wing.probeAnchor, Is.SameAs(anchor));
                Assert.That(wing.motionVectorGenerationMode, Is.EqualTo(MotionVectorGenerationMode.Camera));
                Assert.That((wing.allowOcclusionWhenDynamic, wing.renderingLayerMask), Is.EqualTo((false, 6u)));
                Assert.That((wing.rendererPriority, wing.sortingOrder), Is.EqualTo((3, -4)));
            }
        }

        [Test]
        public void EachWing_HasTheMaterialsOfItsSubmeshes_AndThoseBeyondTheLast()
        {
            Material[] materials = m_Source.sharedMaterials;

            Convert();

            Assert.That(m_Result.Wings[0].sharedMaterials, Is.EqualTo(new[] { materials[1] }));
            Assert.That(m_Result.Wings[1].sharedMaterials, Is.EqualTo(new[] { materials[2], materials[3] }));
            Assert.That(m_Source.sharedMaterials, Is.EqualTo(materials));
        }

        [Test]
        public void PropertiesOfTheRendererAndOfItsMaterials_AreKept()
        {
            var all = new MaterialPropertyBlock();
            all.SetFloat("_Shine", 0.5f);
            m_Source.SetPropertyBlock(all);
            var one = new MaterialPropertyBlock();
            one.SetFloat("_Dust", 0.25f);
            m_Source.SetPropertyBlock(one, 2);

            Convert();

            var kept = new MaterialPropertyBlock();
            m_Result.Wings[0].GetPropertyBlock(kept);
            Assert.That(kept.GetFloat("_Shine"), Is.EqualTo(0.5f));
            m_Result.Wings[0].GetPropertyBlock(kept, 0);
            Assert.That(kept.isEmpty);
            m_Result.Wings[1].GetPropertyBlock(kept, 0);
            Assert.That(kept.GetFloat("_Dust"), Is.EqualTo(0.25f));
        }

        [Test]
        public void WingsAppear_InTheLevelsOfDetailOfTheirSource_AndLeaveThemAfterwards()
        {
            SkinnedMeshRenderer other = m_Insect.Skin("Fly far", new MeshSketch().Box(Vector3.zero, Vector3.one), Weights);
            LODGroup group = m_Insect.Root.gameObject.AddComponent<LODGroup>();
            group.SetLODs(new[] { new LOD(0.5f, new Renderer[] { m_Source }), new LOD(0.1f, new Renderer[] { other }) });

            Convert();

            Assert.That(group.GetLODs()[0].renderers, Is.EqualTo(new Renderer[] { m_Source }.Concat(m_Result.Wings)));
            Assert.That(group.GetLODs()[1].renderers, Is.EqualTo(new Renderer[] { other }));
            m_Result.Restore();
            Assert.That(group.GetLODs()[0].renderers, Is.EqualTo(new Renderer[] { m_Source }));
        }

        [Test]
        public void TheFinder_FindsSkinnedWings_AndAfterwardsThePlainOnes()
        {
            Assert.That(WingFinder.Find(m_Insect.Root), Is.Empty);
            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.EqualTo(new[] { m_Source }));

            Convert();

            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.Empty);
            List<Wing> wings = WingFinder.Find(m_Insect.Root);
            Assert.That(wings.Select(wing => wing.Renderer), Is.EqualTo(m_Result.Wings));
            Assert.That(wings.Select(wing => wing.Side), Is.EqualTo(new[] { WingSide.Right, WingSide.Left }));
            Assert.That(wings.Select(wing => wing.Part), Is.All.EqualTo(WingPart.WholeMesh));
        }

        [Test]
        public void SkinnedWings_AreFoundByTheirBones_EvenIfTheMeshIsNotReadable()
        {
            m_Source.sharedMesh.UploadMeshData(true);

            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.EqualTo(new[] { m_Source }));
            m_Source.enabled = false;
            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.Empty);
        }

        [Test]
        public void ASkinnedBody_WhoseWingBonesMoveNothing_IsNoWing()
        {
            m_Source.sharedMesh.boneWeights = System.Array.ConvertAll(m_Source.sharedMesh.vertices, _ => SkinnedSketch.One(0));
            m_Source.sharedMesh.SetTriangles(new int[0], 1);
            m_Source.sharedMesh.SetTriangles(new int[0], 2);

            Assert.That(WingFinder.FindSkinned(m_Insect.Root), Is.Empty);
        }

        [UnityTest]
        public IEnumerator Restore_GivesTheMeshBack_AndLeavesNothing()
        {
            Mesh mesh = m_Source.sharedMesh;
            Convert();
            Object[] made = m_Result.WingMeshes.Append(m_Result.BodyMesh).Concat<Object>(m_Result.Wings).ToArray();
            Assert.That(m_Source.sharedMesh, Is.Not.SameAs(mesh));

            m_Result.Restore();
            m_Result.Restore();
            yield return null;

            Assert.That(m_Source.sharedMesh, Is.SameAs(mesh));
            Assert.That(m_Source.enabled);
            Assert.That(made, Is.All.Matches<Object>(one => one == null));
            Assert.That(m_Insect.Root.GetComponentsInChildren<MeshRenderer>(true), Is.Empty);
        }

        [UnityTest]
        public IEnumerator Restore_TakesNoHarm_WhereTheInsectIsGone()
        {
            Convert();
            Object.DestroyImmediate(m_Insect.Root.gameObject);
            Mesh mesh = m_Result.BodyMesh;

            m_Result.Restore();
            yield return null;

            Assert.That(mesh == null);
        }

        private void Convert() => m_Result = SkinnedWingConversion.Convert(m_Source, m_Insect.Root);

        private static BoneWeight Weights(Vector3 p)
        {
            if (Mathf.Abs(p.x) < 0.08f)
                return SkinnedSketch.One(0);
            return SkinnedSketch.One(p.x > 0f ? 1 : 2);
        }
    }
}
