using System.Collections.Generic;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Laws of the edges of random triangles.</summary>
    public sealed class MeshEdgesLaws
    {
        [Test]
        public void EveryEdge_StandsOnce_InTheOrderOfTheTriangles_WithTheNumberOfThem()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                int vertices = random.NextInt(1, 40);
                int[] triangles = new int[3 * random.NextInt(120)];
                for (int k = 0; k < triangles.Length; k++)
                    triangles[k] = random.NextInt(vertices);
                var expected = new List<(int Low, int High)>();
                int[,] uses = new int[vertices, vertices];
                for (int k = 0; k < triangles.Length; k++)
                {
                    int a = triangles[k], b = triangles[k % 3 == 2 ? k - 2 : k + 1], low = math.min(a, b), high = math.max(a, b);
                    if (uses[low, high]++ == 0)
                        expected.Add((low, high));
                }

                var edges = new MeshEdges(triangles);

                Assert.That(edges.Count, Is.EqualTo(expected.Count), $"seed {seed}");
                for (int k = 0; k < edges.Count; k++)
                {
                    Assert.That(edges[k], Is.EqualTo(expected[k]), $"seed {seed}, edge {k}");
                    Assert.That(edges.Uses(k), Is.EqualTo(uses[edges[k].Low, edges[k].High]), $"seed {seed}, edge {k}");
                }

                for (int a = 0; a < vertices; a++)
                {
                    for (int b = 0; b < vertices; b++)
                        Assert.That(edges.Uses(a, b), Is.EqualTo(uses[math.min(a, b), math.max(a, b)]), $"seed {seed}, edge {a}–{b}");
                }
            }
        }
    }
}
