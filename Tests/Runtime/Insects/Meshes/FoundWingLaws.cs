using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Wings that are found: alike at any size, at the ends of what counts, and of meshes that cannot be read.</summary>
    public sealed class FoundWingLaws : WingFinderFixture
    {
        // A twentieth of the largest counts.
        [Test]
        public void OfNamedParts_ThoseOfATwentiethOfTheLargestCount(
            [Values(0.01f, 1f, 100f)] float scale, [Values] bool smallFirst)
        {
            m_Insect.Place("Model").localScale = scale * Vector3.one;
            string[] names = { "Wing R", "Wing plate", "Wing screw" };
            float[] areas = { 1f, 0.055f, 0.045f };
            foreach (int k in smallFirst ? new[] { 2, 1, 0 } : new[] { 0, 1, 2 })
            {
                MeshSketch sheet = new MeshSketch().Sheet(new Vector3(0.1f, k, -k), areas[k] * Vector3.right, 0.5f * Vector3.back);
                m_Insect.Draw("Model/" + names[k], sheet);
            }

            IEnumerable<string> found = WingFinder.Find(m_Insect.Root).Select(wing => wing.Renderer.name);
            Assert.That(found, Is.EquivalentTo(new[] { "Wing R", "Wing plate" }));
        }

        [Test]
        public void MirroredParts_AreFoundAtAnySize([Values(0.01f, 1f, 100f)] float scale)
        {
            m_Insect.Place("Model").localScale = scale * Vector3.one;
            m_Insect.Draw("Model/a", m_Insect.Body());
            foreach (float side in new[] { 1f, -1f })
                m_Insect.Draw("Model/b" + side, Wing(side, s_Fore, 1f));
            AssertFound("b1 Fore Right WholeMesh", "b-1 Fore Left WholeMesh");
        }

        // Of one area and in one place, but longer by so much: a quarter of the side of a square of that area.
        [TestCase(1.16f, true)]
        [TestCase(1.18f, false)]
        public void AMirrorImage_IsAsLongAndAsWide(float stretch, bool isPair)
        {
            foreach (float size in new[] { 1e-3f, 1f, 1e3f })
            {
                WingCandidate right = Sheet(size * new Vector3(5f, 0f, 0f), size * new Vector3(4f, 0.1f, 2f));
                WingCandidate left = Sheet(size * new Vector3(-5f, 0f, 0f), size * new Vector3(4f * stretch, 0.1f, 2f / stretch));
                Assert.That(MirrorPairs.Of(new List<WingCandidate> { right, left }), Has.Count.EqualTo(isPair ? 2 : 0));
                WingCandidate above = Sheet(size * new Vector3(-5f, isPair ? 0.69f : 0.72f, 0f), size * new Vector3(4f, 0.1f, 2f));
                Assert.That(MirrorPairs.Of(new List<WingCandidate> { right, above }), Has.Count.EqualTo(isPair ? 2 : 0));
            }
        }

        [Test]
        public void ACandidate_IsOnTheSideOfItsPlace_ThenOfItsName_ThenOfItsMiddle()
        {
            WingCandidate both = Sheet(new Vector3(0.1f, 0f, 0f), new Vector3(4f, 0.1f, 2f));
            Assert.That(both.shape.Side, Is.Null);
            Assert.That(both.Side, Is.EqualTo(WingSide.Right));
            both.namedSide = WingSide.Left;
            Assert.That(both.Side, Is.EqualTo(WingSide.Left));
            Assert.That(Sheet(new Vector3(-0.1f, 0f, 0f), new Vector3(4f, 0.1f, 2f)).Side, Is.EqualTo(WingSide.Left));
            WingCandidate placed = Sheet(new Vector3(9f, 0f, 0f), new Vector3(4f, 0.1f, 2f));
            placed.namedSide = WingSide.Left;
            Assert.That(placed.Side, Is.EqualTo(WingSide.Right));
        }

        [Test]
        public void TheWingOfACandidate_HasAllThatWasFound()
        {
            MeshRenderer renderer = m_Insect.Draw("a", Wing(1f, s_Fore, 1f));
            WingCandidate one = Sheet(new Vector3(-9f, 0f, 0f), new Vector3(4f, 0.1f, 2f));
            (one.renderer, one.part, one.submesh, one.point) = (renderer, WingPart.ConnectedPart, 3, Vector3.up);
            var wing = one.ToWing();
            Assert.That(
                (wing.Renderer, wing.Part, wing.Submesh, wing.Point), Is.EqualTo((renderer, WingPart.ConnectedPart, 3, Vector3.up)));
            Assert.That((wing.Side, wing.Pair, wing.Skeleton), Is.EqualTo((WingSide.Left, WingPair.Fore, (WingSkeleton)null)));
            one.pair = WingPair.Hind;
            Assert.That(one.ToWing().Pair, Is.EqualTo(WingPair.Hind));
        }

        [Test]
        public void AMeshOfBothSides_ThatCannotBeRead_IsNoWing_WhereNoNameTells()
        {
            Unreadable(m_Insect.Draw("Thing", new MeshSketch().Wing(s_Fore, 1f, 0.5f).Wing(Mirror(s_Fore), -1f, 0.5f)));
            AssertFound();
        }

        // Halves of the box of the submesh, not of the mesh with the body and its legs.
        [Test]
        public void ASubmeshOfWings_ThatCannotBeRead_IsToldByItsOwnBox()
        {
            MeshSketch sketch = new MeshSketch().Box(Vector3.zero, 9f * Vector3.one)
                .NextSubmesh().Wing(s_Fore, 1f, 0.5f).Wing(Mirror(s_Fore), -1f, 0.5f);
            Unreadable(m_Insect.Draw("Fly", sketch, "chitin", "wings"));
            AssertFound("Fly Fore Right ConnectedPart", "Fly Fore Left ConnectedPart");
            Assert.That(WingFinder.Find(m_Insect.Root).Select(wing => wing.Point.x), Is.EqualTo(new[] { 1.1f, -1.1f }).Within(1e-5f));
        }

        [TestCase("Wings", true)]
        [TestCase("Thing", false)]
        public void ThickSubmeshes_AreWings_WhereANameSaysSo(string name, bool areWings)
        {
            MeshSketch sketch = new MeshSketch().Box(Vector3.right, Vector3.one).NextSubmesh().Box(Vector3.left, Vector3.one);
            m_Insect.Draw(name, sketch, "Blue", "Blue");
            AssertFound(areWings ? new[] { $"{name} Fore Right Submesh 0", $"{name} Fore Left Submesh 1" } : new string[0]);
        }

        // An insect beside its renderer is none of its parents: all of their names count.
        [Test]
        public void NamesAbove_AreRead_UpToTheInsectOrToTheTop()
        {
            MeshRenderer renderer = m_Insect.Draw("wings/L/thing", new MeshSketch().Box(Vector3.zero, Vector3.one));
            Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
            var stranger = new GameObject("stranger");
            var names = new RendererNames(renderer, mesh, stranger.transform);
            Object.DestroyImmediate(stranger);
            Assert.That((names.IsWing, names.Side), Is.EqualTo((true, (WingSide?)WingSide.Left)));
            names = new RendererNames(renderer, mesh, renderer.transform.parent);
            Assert.That((names.IsWing, names.Side), Is.EqualTo((false, (WingSide?)null)));
        }

        private static void Unreadable(MeshRenderer renderer) => renderer.GetComponent<MeshFilter>().sharedMesh.UploadMeshData(true);

        private static WingCandidate Sheet(Vector3 middle, Vector3 size) =>
            new WingCandidate { shape = WingShape.Of(new Bounds(middle, size), Matrix4x4.identity) };
    }
}
