using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Sorting of parts into wings: what belongs together, what mirrors what, and which is before which.</summary>
    public sealed class WingSortingLaws
    {
        private static readonly Vector3 s_Middle = new Vector3(5f, 0f, 0f), s_Size = new Vector3(4f, 0.1f, 2f);

        // Of a part as long as its whole's tenth 90 % and more lie over the whole's box, along both axes; their middles are nearer along
        // the body than a fifth of the whole's length.
        [TestCase(0f, 0f, 1)]
        [TestCase(1.67f, 0f, 1)]
        [TestCase(1.69f, 0f, 2)]
        [TestCase(-1.67f, 0f, 1)]
        [TestCase(-1.69f, 0f, 2)]
        [TestCase(0f, 0.39f, 1)]
        [TestCase(0f, 0.41f, 2)]
        [TestCase(0f, -0.39f, 1)]
        [TestCase(0f, -0.41f, 2)]
        public void APart_BelongsToAWholeThatItLiesOver(float x, float z, int groups)
        {
            WingShape part = Box(s_Middle + new Vector3(x, 3f, z), new Vector3(0.8f, 0.01f, 0.4f));
            var shapes = new List<WingShape> { part, Box(s_Middle, s_Size) };
            Assert.That(WingGroup.Divide(shapes, out int[] owners), Is.EqualTo(groups));
            Assert.That(owners[0] == owners[1], Is.EqualTo(groups == 1));
        }

        // A part whose middle is near sticks out ahead or behind by more than a tenth.
        [TestCase(0f, 2.2f, 1)]
        [TestCase(0f, 2.3f, 2)]
        [TestCase(0.3f, 1.6f, 1)]
        [TestCase(0.3f, 1.8f, 2)]
        [TestCase(-0.3f, 1.6f, 1)]
        [TestCase(-0.3f, 1.8f, 2)]
        public void APartThatSticksOut_IsOneOfItsOwn(float z, float length, int groups)
        {
            WingShape part = Box(s_Middle + new Vector3(0f, 0f, z), new Vector3(1f, 0.1f, length));
            var shapes = new List<WingShape> { Box(s_Middle, s_Size), part };
            Assert.That(WingGroup.Divide(shapes, out _), Is.EqualTo(groups));
        }

        [Test]
        public void Groups_AreCountedFromTheFront_AndOnTheSideThatHasMore()
        {
            WingShape fore = Box(new Vector3(5f, 0f, 3f), s_Size), hind = Box(new Vector3(5f, 0f, -3f), s_Size),
                vein = Box(new Vector3(5f, 0f, -3f), 0.2f * s_Size), left = Box(new Vector3(-5f, 0f, 3f), s_Size);
            Assert.That(WingGroup.Divide(new List<WingShape> { vein, hind, fore }, out int[] owners), Is.EqualTo(2));
            Assert.That(owners, Is.EqualTo(new[] { 1, 1, 0 }));
            Assert.That(WingGroup.Count(Pieces(fore, hind, vein, left)), Is.EqualTo(2));
            Assert.That(WingGroup.Count(Pieces(left)), Is.EqualTo(1));
            Assert.That(WingGroup.Count(Pieces()), Is.Zero);
        }

        // The area differs by less than a fifth, place and size by less than a quarter of the side of a square of it.
        [TestCase(1f, 0f, 0f, true)]
        [TestCase(0.81f, 0f, 0f, true)]
        [TestCase(0.79f, 0f, 0f, false)]
        [TestCase(1f, 0.69f, 0f, true)]
        [TestCase(1f, 0.72f, 0f, false)]
        [TestCase(1f, 0f, -0.69f, true)]
        [TestCase(1f, 0f, -0.72f, false)]
        public void AMirrorImage_IsAlikeInAreaPlaceAndSize(float area, float aside, float ahead, bool isPair)
        {
            // Narrower by as much along both sides, so that the areas' shares are told by the area.
            float narrow = Mathf.Sqrt(area);
            WingCandidate right = Sheet(s_Middle, s_Size),
                left = Sheet(new Vector3(-5f + aside, 0f, ahead), new Vector3(4f * narrow, 0.1f, 2f * narrow));
            Assert.That(MirrorPairs.Of(new List<WingCandidate> { left, right }), Has.Count.EqualTo(isPair ? 2 : 0));
            WingCandidate other = Sheet(new Vector3(5f, 0f, 0f), s_Size);
            Assert.That(MirrorPairs.Of(new List<WingCandidate> { other, right }), Is.Empty, "of the same side");
        }

        [Test]
        public void OfMirrorImages_TheNearestCounts_TheLargestComeFirst_AndLeavesAreNone()
        {
            WingCandidate fore = Sheet(new Vector3(5f, 0f, 3f), 1.01f * s_Size), hind = Sheet(new Vector3(5f, 0f, -3f), 0.9f * s_Size),
                foreLeft = Sheet(new Vector3(-5f, 0f, 3f), s_Size), hindLeft = Sheet(new Vector3(-5f, 0f, -3f), 0.9f * s_Size),
                near = Sheet(new Vector3(-5f, 0f, 3.2f), s_Size), small = Sheet(new Vector3(5f, 0f, 6f), 0.46f * s_Size),
                smallLeft = Sheet(new Vector3(-5f, 0f, 6f), 0.46f * s_Size), leaf = Sheet(new Vector3(5f, 0f, 6f), 0.44f * s_Size),
                leafLeft = Sheet(new Vector3(-5f, 0f, 6f), 0.44f * s_Size);
            Assert.That(MirrorPairs.Of(new List<WingCandidate> { near, hindLeft, hind, foreLeft, fore }),
                Is.EquivalentTo(new[] { fore, foreLeft, hind, hindLeft }));
            Assert.That(MirrorPairs.Of(new List<WingCandidate> { small, smallLeft, fore, foreLeft }),
                Is.EqualTo(new[] { fore, foreLeft, small, smallLeft }).Or.EqualTo(new[] { foreLeft, fore, smallLeft, small })
                    .Or.EqualTo(new[] { fore, foreLeft, smallLeft, small }).Or.EqualTo(new[] { foreLeft, fore, small, smallLeft }));
            Assert.That(
                MirrorPairs.Of(new List<WingCandidate> { leaf, leafLeft, fore, foreLeft }), Is.EquivalentTo(new[] { fore, foreLeft }));
            Assert.That(MirrorPairs.Of(new List<WingCandidate> { small, smallLeft, fore, foreLeft, hind, hindLeft }),
                Is.EquivalentTo(new[] { fore, foreLeft, hind, hindLeft }), "two pairs at most");
        }

        [Test]
        public void Wings_AreListed_ForePairFirst_RightBeforeLeft_LargeBeforeSmall()
        {
            WingCandidate foreRight = Sheet(new Vector3(5f, 0f, 3f), s_Size), foreLeft = Sheet(new Vector3(-5f, 0f, 3f), s_Size),
                hindRight = Sheet(new Vector3(5f, 0f, -3f), s_Size), hindLeft = Sheet(new Vector3(-5f, 0f, -3f), s_Size),
                vein = Sheet(new Vector3(5f, 0f, 3f), 0.2f * s_Size);
            var wings = new List<WingCandidate> { vein, hindLeft, hindRight, foreLeft, foreRight };
            WingPairing.Assign(wings);
            wings.Sort(WingPairing.Compare);
            Assert.That(wings, Is.EqualTo(new[] { foreRight, vein, foreLeft, hindRight, hindLeft }));
            Assert.That(wings.Select(wing => wing.pair),
                Is.EqualTo(new[] { WingPair.Fore, WingPair.Fore, WingPair.Fore, WingPair.Hind, WingPair.Hind }));

            // What a name says counts: the front one called hind leaves the other the fore pair.
            foreRight.pair = WingPair.Hind;
            hindRight.pair = vein.pair = null;
            foreLeft.pair = null;
            hindLeft.pair = WingPair.Fore;
            WingPairing.Assign(wings);
            Assert.That(new[] { foreRight.pair, vein.pair, hindRight.pair, foreLeft.pair, hindLeft.pair },
                Is.EqualTo(new WingPair?[] { WingPair.Hind, WingPair.Hind, WingPair.Fore, WingPair.Hind, WingPair.Fore }));

            var only = new List<WingCandidate> { Sheet(s_Middle, s_Size) };
            only[0].pair = WingPair.Hind;
            WingPairing.Assign(only);
            Assert.That(only[0].pair, Is.EqualTo(WingPair.Fore), "the only pair is the fore pair");
        }

        [Test]
        public void APartWithoutArea_IsOnNeitherSide_AndNoSheet()
        {
            Vector3[] positions = new[] { new Vector3(1f, 0f, 0f), new Vector3(2f, 0f, 0f), new Vector3(5f, 0f, 0f) };
            var shape = WingShape.Of(positions, new MeshSelection(new[] { 0, 1, 2 }, new[] { 0, 1, 2 }), Matrix4x4.identity);
            Assert.That((shape.area, shape.rightShare, shape.isSheet, shape.Side), Is.EqualTo((0f, 0.5f, false, (WingSide?)null)));
            Assert.That(shape.centroid, Is.EqualTo(new Vector3(3f, 0f, 0f)), "the middle of its box");
        }

        // Tangents are read by any shader that nobody knows, and by those of pipelines only with a map that needs them.
        [Test]
        public void Tangents_AreRead_WhereAnyMaterialMayReadThem()
        {
            MeshRenderer renderer = new GameObject("drawn").AddComponent<MeshRenderer>();
            var plain = new Material(Shader.Find("Standard"));
            var mapped = new Material(Shader.Find("Standard"));
            mapped.EnableKeyword("_NORMALMAP");
            foreach ((Material[] materials, bool areRead) in new[]
            {
                (new Material[0], true), (new[] { plain }, false), (new[] { plain, plain }, false), (new[] { mapped }, true),
                (new[] { plain, mapped }, true), (new[] { plain, null }, true),
            })
            {
                renderer.sharedMaterials = materials;
                Assert.That(MaterialTangents.AreRead(renderer), Is.EqualTo(areRead), $"{materials.Length} materials");
            }

            Object.DestroyImmediate(renderer.gameObject);
            Object.DestroyImmediate(plain);
            Object.DestroyImmediate(mapped);
        }

        private static List<(WingShape shape, Vector3 point, int submesh)> Pieces(params WingShape[] shapes) =>
            shapes.Select(shape => (shape, Vector3.zero, 0)).ToList();

        private static WingShape Box(Vector3 middle, Vector3 size) => WingShape.Of(new Bounds(middle, size), Matrix4x4.identity);

        private static WingCandidate Sheet(Vector3 middle, Vector3 size) => new WingCandidate { shape = Box(middle, size) };
    }
}
