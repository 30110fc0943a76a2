using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Crowds
{
    /// <summary>Smaller meshes of baked insects.</summary>
    public sealed class ReducedSurfaceTests
    {
        private static readonly int[] s_Triangles = { 2000, 500, 160 };

        [TestCase("monarch")]
        [TestCase("swallowtail", Explicit = true, Category = "Long")]
        [TestCase("firefly", Explicit = true, Category = "Long")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", Explicit = true, Category = "Long")]
        [TestCase("snailfish", Explicit = true, Category = "Long")]
        [TestCase("dragonfly", Explicit = true, Category = "Long")]
        public void EachSize_IsOfVerticesOfTheOneBefore_AndKeepsTheWings(string species)
        {
            InsectBake bake = Bake(species);
            ReducedSurface[] sizes = ReducedSurface.Of(bake, s_Triangles);

            TestContext.Out.WriteLine($"{species}: off by {string.Join(", ", sizes.Select(size => size.Error.ToString("0.00 %")))}");
            for (int size = 0; size < sizes.Length; size++)
            {
                Assert.That(sizes[size].TriangleCount, Is.InRange(s_Triangles[size] * 9 / 10, s_Triangles[size]));
                if (size > 0)
                    Assert.That(sizes[size].Vertices, Is.SubsetOf(sizes[size - 1].Vertices));
            }

            Assert.That(sizes[0].Error, Is.LessThan(2e-3f));
            Assert.That(sizes[1].Error, Is.LessThan(5e-3f));
            Assert.That(sizes[2].Error, Is.LessThan(1.5e-2f));
        }

        [Test]
        public void SmallerMeshes_KeepTheAreaOfTheWings()
        {
            InsectBake bake = Bake("monarch");
            ReducedSurface smallest = ReducedSurface.Of(bake, s_Triangles)[2];
            float whole = AreaOf(bake, bake.Surface.Parts.Select(part => part.Triangles)), kept = AreaOf(bake, smallest.Parts);

            Assert.That(kept, Is.EqualTo(whole).Within(0.03f * whole));
        }

        private static InsectBake Bake(string species)
        {
            var parts = InsectParts.Make(InsectCatalogue.Find(species));
            GameObject made = parts.Assemble(parts.CreatePresets(InsectVariant.Standard, ModelReading.Physical));
            try
            {
                return InsectBaker.Bake(made.GetComponent<InsectWings>(), new[] { BakeMotion.Find("cruise") }, new BakeSettings(8));
            }
            finally
            {
                Object.DestroyImmediate(made);
                parts.Destroy();
            }
        }

        private static float AreaOf(InsectBake bake, IEnumerable<int[]> parts)
        {
            var wings = new HashSet<int>(bake.Wings.SelectMany(wing => wing.Vertices));
            float area = 0f;
            foreach (int[] part in parts)
            {
                for (int k = 0; k < part.Length; k += 3)
                {
                    float3 a = bake.Surface.Positions[part[k]], b = bake.Surface.Positions[part[k + 1]],
                        c = bake.Surface.Positions[part[k + 2]];
                    area += wings.Contains(part[k]) ? 0.5f * math.length(math.cross(b - a, c - a)) : 0f;
                }
            }

            return area;
        }
    }
}
