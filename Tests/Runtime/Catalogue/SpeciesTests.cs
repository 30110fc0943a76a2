using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Fitting;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class SpeciesTests
    {
        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [TestCase("monarch")]
        [TestCase("Monarch")]
        [TestCase(" MON-arch ")]
        public void ASpecies_IsFound_HoweverItsNameIsWritten(string name)
        {
            Assert.That(InsectCatalogue.TryFind(name, out InsectDefinition found), Is.True);
            Assert.That(found.DisplayName, Is.EqualTo("Monarch"));
        }

        [TestCase("unicorn")]
        [TestCase("")]
        [TestCase(null)]
        public void AnUnknownSpecies_IsRefused_WithTheNamesThereAre(string name)
        {
            Assert.That(InsectCatalogue.TryFind(name, out _), Is.False);
            Assert.That(InsectCatalogue.TryCreate(name, out WingPreset preset), Is.False);
            Assert.That(preset == null, Is.True);
            Assert.That(() => InsectCatalogue.Find(name), Throws.ArgumentException.With.Message.Contains("monarch"));
        }

        [TestCase("monarch", 4192)]
        [TestCase("firefly", 12568)]
        [TestCase("fishfly", 1210)]
        [TestCase("painted-lichen-moth", 1648)]
        public void TheSpeciesOfThePapersTable2_HaveItsTriangles(string species, int triangles)
        {
            InsectDefinition definition = InsectCatalogue.Find(species);
            int meshed = 0;
            foreach (WingDefinition wing in definition.Wings)
            {
                meshed += wing.CreateSurface(WingSide.Right).TriangleCount + wing.CreateSurface(WingSide.Left).TriangleCount;
            }

            Assert.That(meshed, Is.EqualTo(triangles));
            Assert.That(definition.TriangleCount, Is.EqualTo(triangles));
        }

        // A table knows the numbers that it was made of: mass, body, hinges, wings and beat.
        [TestCaseSource(nameof(All))]
        public void TheTrimTableOfASpecies_IsMadeOfItsPresentNumbers(InsectDefinition species)
        {
            using FlightModel model = CatalogueFlight.CreateModel(species);
            using TrimTable table = CatalogueFlight.CreateTable(species, model);
            Assert.That(table, Is.Not.Null);
        }

        // What was meshed for one insect is kept for the next.
        [Test]
        public void AWing_IsMeshedAsItsNumbersSayNow_InArraysOfItsOwn()
        {
            WingDefinition model = InsectCatalogue.Find("dragonfly").Wings[0], other = InsectCatalogue.Find("monarch").Wings[0];
            var wing = new WingDefinition("copy", model, model.Length, null);
            SurfaceMesh first = wing.CreateSurface(WingSide.Right), second = wing.CreateSurface(WingSide.Right);
            Assert.That(second.positions, Is.EqualTo(first.positions).And.Not.SameAs(first.positions));
            Assert.That(second.colours, Is.EqualTo(first.colours).And.Not.SameAs(first.colours));
            first.positions[0] = second.normals[0] = new Vector3(9f, 9f, 9f);
            first.triangles[0] = first.triangles[1];
            second.uvs[0] = new Vector2(9f, 9f);
            SurfaceMesh third = wing.CreateSurface(WingSide.Right);
            Assert.That((third.positions[0], third.uvs[0]), Is.EqualTo((second.positions[0], first.uvs[0])));
            Assert.That((third.normals[0], third.triangles), Is.EqualTo((first.normals[0], second.triangles)));

            Assert.That(wing.CreateSurface(WingSide.Right, 20f).positions[0], Is.EqualTo(2f * third.positions[0]));
            Assert.That(wing.CreateSurface(WingSide.Left, 20f).positions[9], Is.EqualTo(Mirrored(2f * third.positions[9])));
            wing.TriangleCount = 200;
            Assert.That(wing.CreateSurface(WingSide.Right, 20f).TriangleCount, Is.EqualTo(200));
            Color32[] before = wing.CreateSurface(WingSide.Right).colours;
            wing.Pattern = other.Pattern;
            Assert.That(wing.CreateSurface(WingSide.Right).colours, Is.Not.EqualTo(before));
            Vector3[] smooth = wing.CreateSurface(WingSide.Right).positions;
            wing.Scallops = InsectCatalogue.Find("snailfish").Wings[0].Scallops;
            Assert.That(wing.CreateSurface(WingSide.Right).positions, Is.Not.EqualTo(smooth));
            wing.IsFilled = false;
            SurfaceMesh strips = WingMesher.Strips(wing.Contour, 200, (float)wing.Length * InsectDefinition.UnitsPerMetre);
            Assert.That(wing.CreateSurface(WingSide.Right).positions, Is.EqualTo(strips.positions));
        }

        private static Vector3 Mirrored(Vector3 place) => new Vector3(-place.x, place.y, place.z);

        [TestCaseSource(nameof(All))]
        public void EachSpecies_SaysWhereItsNumbersComeFrom(InsectDefinition species)
        {
            Assert.That(species.Sources, Is.Not.Empty);
            foreach (InsectSource source in species.Sources)
            {
                Assert.That(source.Source, Is.Not.Empty, source.Quantity);
            }
        }

        [TestCaseSource(nameof(All))]
        public void EachWing_HasASkeletonThatIsUsable_WhoseChainsEndOnItsMargin(InsectDefinition species)
        {
            foreach (WingDefinition wing in species.Wings)
            {
                foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
                {
                    WingSkeleton skeleton = wing.CreateSkeleton(side);
                    SurfaceMesh surface = wing.CreateSurface(side);

                    Assert.That(skeleton.Validate(), Is.Empty);
                    Vector3[] rim = SkeletonFitter.Fit(surface, SkeletonFitSettings.Default).Outline;
                    Assert.That(new FitMeasure(skeleton, rim).TipsOffMargin(), Is.LessThan(0.015), "rounding moves the tip a little");
                    UnityEngine.Object.DestroyImmediate(skeleton);
                }
            }
        }

        [TestCaseSource(nameof(All))]
        public void EachWing_IsMeshedInItsNumberOfTriangles_WithAColourForEachVertex(InsectDefinition species)
        {
            foreach (WingDefinition wing in species.Wings)
            {
                SurfaceMesh surface = wing.CreateSurface(WingSide.Right);

                Assert.That(surface.TriangleCount, Is.EqualTo(wing.TriangleCount));
                Assert.That(surface.colours, Has.Length.EqualTo(surface.VertexCount));
            }
        }

        [TestCaseSource(nameof(All))]
        public void EachWing_BakesIntoARig_OfItsOwnAreaAndLength(InsectDefinition species)
        {
            foreach (WingDefinition wing in species.Wings)
            {
                WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right);
                SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
                var rig = WingRig.Bake(skeleton, surface, WingRigSettings.Default);

                Assert.That(rig.TriangleCount, Is.EqualTo(wing.TriangleCount));
                Assert.That(rig.ChainCount, Is.EqualTo(wing.Chains));
                Assert.That(rig.Frame.length, Is.EqualTo(LargestSpan(surface)).Within(0.01).Percent);
                Assert.That(rig.Frame.length, Is.EqualTo(wing.Outline.Length * InsectDefinition.UnitsPerMetre).Within(0.5).Percent,
                    "rounding shortens the tip a little");
                rig.Release();
                UnityEngine.Object.DestroyImmediate(skeleton);
            }
        }

        [TestCaseSource(nameof(All))]
        public void EachWing_SitsOnItsBody(InsectDefinition species)
        {
            SurfaceMesh body = species.Body.CreateSurface(InsectDefinition.UnitsPerMetre);
            foreach (WingDefinition wing in species.Wings)
            {
                Vector3 hinge = wing.HingeOn(WingSide.Right);
                float nearest = float.MaxValue;
                foreach (Vector3 position in body.positions)
                {
                    nearest = Math.Min(nearest, (position - hinge).magnitude);
                }

                Assert.That(nearest, Is.LessThan(0.03f * wing.Outline.Length * InsectDefinition.UnitsPerMetre));
            }
        }

        [TestCaseSource(nameof(All))]
        public void BothPresets_OfEachWing_AreInRange(InsectDefinition species)
        {
            foreach (WingDefinition wing in species.Wings)
            {
                foreach (ModelReading preset in new[] { ModelReading.Physical, ModelReading.Paper })
                {
                    WingPreset made = wing.CreatePreset(preset);

                    Assert.That(made.ToParameters().FindProblem(), Is.Null);
                    Assert.That(made.WingLength, Is.EqualTo(wing.Outline.Length).Within(1).Percent);
                    UnityEngine.Object.DestroyImmediate(made);
                }
            }
        }

        private static float LargestSpan(SurfaceMesh surface)
        {
            float largest = 0f;
            foreach (Vector3 position in surface.positions)
            {
                largest = Math.Max(largest, Math.Abs(position.x));
            }

            return largest;
        }
    }
}
