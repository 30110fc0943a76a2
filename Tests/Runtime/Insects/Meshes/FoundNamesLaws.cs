using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Names and levels of detail by which renderers are found, and the pose in which skins are measured.</summary>
    public sealed class FoundNamesLaws
    {
        private InsectSketch m_Insect;

        [SetUp]
        public void MakeAnInsect() => m_Insect = new InsectSketch();

        [TearDown]
        public void EndIt() => m_Insect.Dispose();

        [TestCase("ForeWingL2_HTMLName", ExpectedResult = "fore wing l html name")]
        [TestCase("a", ExpectedResult = "a")]
        [TestCase("AB", ExpectedResult = "ab")]
        [TestCase("ABc", ExpectedResult = "a bc")]
        [TestCase("aB", ExpectedResult = "a b")]
        [TestCase("wing.001", ExpectedResult = "wing")]
        [TestCase("3D wing", ExpectedResult = "d wing")]
        [TestCase("-_ ", ExpectedResult = "")]
        [TestCase("", ExpectedResult = "")]
        public string Words_BeginWithCapitals_AndEndWhereLettersEnd(string name) => string.Join(" ", NameWords.Of(name));

        [TestCase("fore front upper top anterior", (int)WingWord.Fore)]
        [TestCase("hind rear back lower bottom posterior", (int)WingWord.Hind)]
        [TestCase("left l", (int)WingWord.Left)]
        [TestCase("right r", (int)WingWord.Right)]
        [TestCase("fl lf", (int)(WingWord.Fore | WingWord.Left))]
        [TestCase("fr rf", (int)(WingWord.Fore | WingWord.Right))]
        [TestCase("hl lh bl lb rl", (int)(WingWord.Hind | WingWord.Left))]
        [TestCase("hr rh br rb rr", (int)(WingWord.Hind | WingWord.Right))]
        [TestCase("wing wings fin fins", (int)WingWord.Wing)]
        [TestCase("body thorax tail dorsal", (int)WingWord.Body)]
        [TestCase("hinge collider shadow", (int)WingWord.Mount)]
        [TestCase("elytra case shell haltere", (int)WingWord.Case)]
        [TestCase("mesh bone lod", (int)WingWord.Plain)]
        public void EachWord_HasItsMeaning_AloneAndBesideAWing(string words, int meaning)
        {
            foreach (string word in words.Split(' '))
            {
                Assert.That(WingWords.Read(word, out WingWord alone), Is.True, word);
                Assert.That((int)alone, Is.EqualTo(meaning), word);
                WingWords.Read(word + "_wing", out WingWord beside);
                Assert.That((int)beside, Is.EqualTo(meaning | (int)WingWord.Wing), word);
            }

            Assert.That(WingWords.Read("grass " + words, out WingWord together), Is.False, "one of them is unknown");
            Assert.That((int)together, Is.EqualTo(meaning), "the others count");
        }

        // What is nearest to the renderer tells side and pair; above it only what names a wing and nothing else tells a wing.
        [TestCase("thing", "Mesh", ExpectedResult = "")]
        [TestCase("wing_L", "Mesh", ExpectedResult = "wing left")]
        [TestCase("thing", "wing_R", ExpectedResult = "wing right")]
        [TestCase("wing_L", "wing_R", ExpectedResult = "wing left")]
        [TestCase("hindwings/L", "Mesh", ExpectedResult = "wing hind left")]
        [TestCase("Monarch Wings/L", "Mesh", ExpectedResult = "left")]
        [TestCase("left/fore/wing", "hind", ExpectedResult = "wing hind left")]
        [TestCase("elytra/wing_L", "Mesh", ExpectedResult = "case wing left")]
        public string ARenderer_HasTheNamesOfItsMeshAndOfItsParents(string path, string mesh)
        {
            MeshRenderer renderer = m_Insect.Draw("rig/" + path, new MeshSketch().Box(Vector3.zero, Vector3.one));
            Mesh drawn = renderer.GetComponent<MeshFilter>().sharedMesh;
            drawn.name = mesh;
            m_Insect.Root.name = "wing_R";
            var names = new RendererNames(renderer, drawn, m_Insect.Root);
            string said = $"{(names.IsCase ? "case" : "")} {(names.IsWing ? "wing" : "")} {names.Pair} {names.Side}";
            return string.Join(" ", said.ToLowerInvariant().Split(new[] { ' ' }, System.StringSplitOptions.RemoveEmptyEntries));
        }

        [Test]
        public void AMaterial_IsReadByItsSubmesh_AndOneThatThereIsNotHasNoMeaning()
        {
            MeshRenderer renderer = m_Insect.Draw("thing", new MeshSketch().Box(Vector3.zero, Vector3.one), "body", "wing_L");
            renderer.sharedMaterials = new[] { renderer.sharedMaterials[0], renderer.sharedMaterials[1], null };
            var names = new RendererNames(renderer, renderer.GetComponent<MeshFilter>().sharedMesh, m_Insect.Root);
            Assert.That(names.Material(0).IsWing, Is.False);
            Assert.That((names.Material(1).IsWing, names.Material(1).Side), Is.EqualTo((true, (WingSide?)WingSide.Left)));
            Assert.That(names.Material(2).NamesWing || names.Material(3).NamesWing, Is.False);
        }

        [Test]
        public void OfLevelsOfDetail_TheFirstIsDrawn_AndHiddenOnesWhereTheyAreAskedFor()
        {
            MeshRenderer fine = Drawn("lods/fine"), both = Drawn("lods/both"), coarse = Drawn("lods/coarse"), plain = Drawn("plain");
            MeshRenderer off = Drawn("off"), below = Drawn("closed/below");
            off.enabled = false;
            below.transform.parent.gameObject.SetActive(false);
            Drawn("empty").GetComponent<MeshFilter>().sharedMesh = null;
            LODGroup group = fine.transform.parent.gameObject.AddComponent<LODGroup>();
            group.SetLODs(new[] { new LOD(0.5f, new Renderer[] { fine, both }), new LOD(0.1f, new Renderer[] { coarse, both }) });

            Assert.That(DrawnRenderers.Under(m_Insect.Root, false), Is.EquivalentTo(new Renderer[] { fine, both, plain }));
            Assert.That(DrawnRenderers.Under(m_Insect.Root, true), Is.EquivalentTo(new Renderer[] { fine, both, plain, off, below }));
            m_Insect.Root.gameObject.SetActive(false);
            Assert.That(DrawnRenderers.Under(m_Insect.Root, false), Is.EquivalentTo(new Renderer[] { fine, both, plain }),
                "one that is off itself is measured all the same");
        }

        [Test]
        public void ASkin_IsWhereItsRootBoneHasIt_OrItsFirst_OrItself()
        {
            using (var sketch = new SkinnedSketch())
            {
                Transform first = sketch.Bone("first", new Vector3(1f, 2f, 3f));
                Transform root = sketch.Bone("root", new Vector3(-3f, 0f, 1f), scale: 2f);
                MeshSketch box = new MeshSketch().Box(Vector3.zero, Vector3.one);
                SkinnedMeshRenderer skin = sketch.Skin("skin", box, _ => SkinnedSketch.One(0));
                first.localPosition += Vector3.up;
                root.localPosition += Vector3.right;
                Matrix4x4[] binds = skin.sharedMesh.bindposes;
                skin.rootBone = root;
                Near(skin, root.localToWorldMatrix * binds[1]);
                skin.rootBone = null;
                Near(skin, first.localToWorldMatrix * binds[0]);
                skin.bones = new[] { null, root };
                Near(skin, root.localToWorldMatrix * binds[1]);
                skin.bones = new Transform[0];
                Near(skin, skin.transform.localToWorldMatrix);
            }
        }

        private static void Near(SkinnedMeshRenderer skin, Matrix4x4 wanted)
        {
            Matrix4x4 found = SkinnedPose.ToWorld(skin);
            foreach (Vector3 point in new List<Vector3> { Vector3.zero, Vector3.right, Vector3.up, Vector3.forward })
                Assert.That((found.MultiplyPoint3x4(point) - wanted.MultiplyPoint3x4(point)).magnitude, Is.LessThan(1e-5f));
        }

        private MeshRenderer Drawn(string path) => m_Insect.Draw(path, new MeshSketch().Box(Vector3.zero, Vector3.one));
    }
}
