using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Bones that are named wings, their roots, and their weights at vertices.</summary>
    public sealed class WingBonesLaws
    {
        private SkinnedSketch m_Insect;

        [SetUp]
        public void MakeAnInsect() => m_Insect = new SkinnedSketch();

        [TearDown]
        public void EndIt() => m_Insect.Dispose();

        [TestCase("wing", ExpectedResult = "wing")]
        [TestCase("wing_L", ExpectedResult = "wing left")]
        [TestCase("hindwing_R", ExpectedResult = "wing hind right")]
        [TestCase("chest/wing_L/strut", ExpectedResult = "wing left")]
        [TestCase("wings/chest", ExpectedResult = "", Description = "a folder of all bones")]
        [TestCase("forewings/chest", ExpectedResult = "", Description = "has no side")]
        [TestCase("elytra_L/strut", ExpectedResult = "case")]
        [TestCase("chest", ExpectedResult = "")]
        public string ABone_IsNamed_ByItselfOrByWhatItHangsOn(string path)
        {
            m_Insect.Bone(path);
            return Said(Bones(_ => SkinnedSketch.One(0)).Name(0));
        }

        [Test]
        public void ABoneWithoutASide_NamesThoseBelowIt_WhereItIsABone()
        {
            m_Insect.Bone("wing");
            m_Insect.Bone("wing/strut");
            WingBones bones = Bones(_ => SkinnedSketch.One(0));
            Assert.That((bones.Count, bones.IsSkinned), Is.EqualTo((2, true)));
            Assert.That(Said(bones.Name(1)), Is.EqualTo("wing"));
            Assert.That(bones[1], Is.SameAs(m_Insect.Bones[1]));
        }

        [Test]
        public void TheRootOfAWing_IsItsUppermostBone_OfItsSideAndPair()
        {
            string[] paths =
            {
                "chest", "chest/wing_R", "chest/wing_R/wing_R_2", "chest/wing_R/wing_R_2/wing_R_3", "chest/wing_L", "chest/wing_L/tip",
                "chest/wing_R/hindwing_R",
            };
            foreach (string path in paths)
                m_Insect.Bone(path);
            WingBones bones = Bones(_ => SkinnedSketch.One(0));
            int[] roots = { 0, 1, 1, 1, 4, 4, 6 };
            for (int bone = 0; bone < roots.Length; bone++)
                Assert.That(bones.RootOf(bone), Is.EqualTo(roots[bone]), paths[bone]);
        }

        // What is between two bones of a wing and is no bone itself does not end it.
        [Test]
        public void TheRootOfAWing_IsFound_AcrossWhatIsNoBone()
        {
            m_Insect.Bone("wing_L");
            m_Insect.Bone("wing_L/offset/tip");
            Assert.That(Bones(_ => SkinnedSketch.One(0)).RootOf(1), Is.Zero);
        }

        [TestCase(0.49f, false)]
        [TestCase(0.51f, true)]
        public void ATriangle_IsAWings_WhereMostOfItsWeightIs(float share, bool isWing)
        {
            m_Insect.Bone("chest");
            m_Insect.Bone("chest/wing_R");
            WingBones bones = Bones(_ => SkinnedSketch.Two(0, 1, share));
            Assert.That(bones.IsWing(0, 1, 2), Is.EqualTo(isWing));
        }

        [Test]
        public void AllFourWeights_OfAVertex_Count()
        {
            foreach (string bone in new[] { "chest", "chest/wing_R", "chest/wing_R/b", "chest/wing_R/c" })
                m_Insect.Bone(bone);
            WingBones bones = Bones(_ => new BoneWeight
            {
                boneIndex0 = 2,
                weight0 = 0.4f,
                boneIndex1 = 0,
                weight1 = 0.3f,
                boneIndex2 = 3,
                weight2 = 0.2f,
                boneIndex3 = 1,
                weight3 = 0.1f,
            });
            float[] sums = { 1f, 2f, 3f, 4f };
            bones.AddWeights(1, sums);
            Assert.That(sums, Is.EqualTo(new[] { 1.3f, 2.1f, 3.4f, 4.2f }).Within(1e-6f));
            Assert.That(bones.IsWing(0, 0, 0), Is.True, "0.7 of it");
            bones.AddWeights(0, sums = new float[2]);
            Assert.That(sums, Is.EqualTo(new[] { 0.3f, 0.1f }).Within(1e-6f), "bones beyond the sums have none");
        }

        private WingBones Bones(System.Func<Vector3, BoneWeight> weights) =>
            new WingBones(m_Insect.Skin("skin", new MeshSketch().Box(Vector3.zero, Vector3.one), weights), m_Insect.Root);

        private static string Said(WingName name)
        {
            string what = name.IsCase ? "case" : name.NamesWing ? $"wing {name.Pair} {name.Side}" : "";
            return what.Replace("  ", " ").Trim().ToLowerInvariant();
        }
    }
}
