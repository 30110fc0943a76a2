using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class PatchTests : RigFixture
    {
        [Test]
        public void WithoutANumber_EveryTriangleIsAPatch()
        {
            WingRig rig = Bake(TestWings.Fan(), TestWings.Ellipse(10, 5));

            Assert.That(rig.TriangleCount, Is.EqualTo(100));
            Assert.That(rig.PatchCount, Is.EqualTo(100));
        }

        // Four cells of 0.5 by 0.25 with eight patches each: squares of an eighth.
        [Test]
        public void Patches_AreAsLongAsWide()
        {
            WingRig rig = Bake(TestWings.Lattice(3, 3), TestWings.Rectangle(48, 24), 32);
            Assert.That(rig.PatchCount, Is.EqualTo(32));
            var places = new HashSet<(int, int)>();
            for (int patch = 0; patch < 32; patch++)
            {
                float x = rig.View.patchSpan[patch] * 8f - 0.5f, z = -rig.View.patchChord[patch] * 8f - 0.5f;
                Assert.That(rig.View.patchAreas[patch], Is.EqualTo(1f / 64f).Within(1e-5f));
                Assert.That(math.abs(x - math.round(x)) + math.abs(z - math.round(z)), Is.LessThan(1e-3f), $"{x}, {z}");
                Assert.That(places.Add(((int)math.round(x), (int)math.round(z))), Is.True);
            }
        }

        [Test]
        public void MorePatchesThanTriangles_AreAsManyAsTriangles()
        {
            Assert.That(Bake(TestWings.Fan(), TestWings.Ellipse(10, 5), 5000).PatchCount, Is.EqualTo(100));
        }

        [TestCase(1)]
        [TestCase(17)]
        [TestCase(64)]
        [TestCase(256)]
        [TestCase(1000)]
        public void ANumber_IsRoughlyKept(int wanted)
        {
            WingRig rig = Bake(TestWings.Fan(), TestWings.Ellipse(60, 40), wanted);

            Assert.That(rig.PatchCount, Is.LessThanOrEqualTo(wanted + rig.CellCount));
            Assert.That(rig.PatchCount, Is.GreaterThanOrEqualTo(0.85f * wanted));
            for (int cell = 0; cell < rig.CellCount; cell++)
                Assert.That(rig.View.patchCells[cell].patchCount, Is.GreaterThan(0), $"cell {cell}");
        }

        [Test]
        public void Patches_FollowOneAnotherCellByCell()
        {
            WingRig rig = Bake(64);
            int next = 0;
            for (int cell = 0; cell < rig.CellCount; cell++)
            {
                Assert.That(rig.View.patchCells[cell].firstPatch, Is.EqualTo(next));
                next += rig.View.patchCells[cell].patchCount;
            }

            Assert.That(next, Is.EqualTo(rig.PatchCount));
        }

        // Of z √(1 − 0.99 x²) ahead and behind, by which the ellipse is narrowed.
        [Test]
        public unsafe void Patches_KnowAQuarterOfTheirChord()
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Ellipse(48, 12), 64);
            for (int patch = 0; patch < rig.PatchCount; patch++)
            {
                float x = rig.View.patchSpan[patch] / TestWings.Length;
                double wanted = 0.25 * TestWings.Chord * System.Math.Sqrt(1.0 - 0.99 * x * x);
                Assert.That(rig.View.patchQuarterChords[patch], Is.EqualTo(wanted).Within(2).Percent, $"at {x}");
            }
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(64)]
        public void Patches_HaveTheAreaAndCentreOfTheWing(int wanted)
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Rectangle(40, 30), wanted);
            double area = 0.0;
            float3 moment = default;
            for (int patch = 0; patch < rig.PatchCount; patch++)
            {
                Assert.That(rig.View.patchAreas[patch], Is.GreaterThan(0f));
                area += rig.View.patchAreas[patch];
                moment += rig.View.patchAreas[patch] * Centre(rig, patch);
            }

            Assert.That(area, Is.EqualTo(0.5).Within(1e-5));
            Assert.That(rig.Area, Is.EqualTo(0.5f).Within(1e-5f));
            Assert.That(math.distance(moment / (float)area, new float3(0.5f, 0f, -0.25f)), Is.LessThan(1e-5f));
        }

        [TestCase(0)]
        [TestCase(64)]
        public void TheCoordinatesOfAPatch_NameItsCentre(int wanted)
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Rectangle(40, 30), wanted);
            foreach ((int cell, int patch) in Patches(rig))
            {
                float u = rig.View.patchU[patch], v = rig.View.patchV[patch];
                int joint = cell / 4 * 5 + cell % 4;
                float3 named = (1f - u) * ((1f - v) * rig.RestJoints[joint] + v * rig.RestJoints[joint + 1])
                    + u * ((1f - v) * rig.RestJoints[joint + 5] + v * rig.RestJoints[joint + 6]);
                Assert.That(math.distance(named, Centre(rig, patch)), Is.LessThan(1e-5f));
            }
        }

        // Flat wings only: y is 0.
        private static float3 Centre(WingRig rig, int patch) => new float3(rig.View.patchSpan[patch], 0f, rig.View.patchChord[patch]);

        private static List<(int, int)> Patches(WingRig rig)
        {
            var patches = new List<(int, int)>();
            for (int cell = 0; cell < rig.CellCount; cell++)
            {
                PatchCell c = rig.View.patchCells[cell];
                for (int patch = c.firstPatch; patch < c.firstPatch + c.patchCount; patch++)
                    patches.Add((cell, patch));
            }

            return patches;
        }
    }
}
