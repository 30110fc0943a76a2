using System;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class ColourTextureTests
    {
        private const int k_Size = 512;

        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [TestCaseSource(nameof(All))]
        public void TheTextureOfABody_HasTheColoursOfItsTriangles_AtTheirPlacesInIt(InsectDefinition species)
        {
            SurfaceMesh body = species.Body.CreateSurface(1f);
            Color32[] pixels = ColourTexture.Paint(body, k_Size);
            int compared = 0;
            for (int corner = 0; corner < body.triangles.Length; corner += 3)
            {
                int i = body.triangles[corner], j = body.triangles[corner + 1], k = body.triangles[corner + 2];
                Color a = body.colours[i], b = body.colours[j], c = body.colours[k];
                if (Area(body.uvs[i], body.uvs[j], body.uvs[k]) < 8f)
                {
                    continue;
                }

                Vector2 middle = k_Size * (body.uvs[i] + body.uvs[j] + body.uvs[k]) / 3f;
                Color painted = pixels[(int)middle.y * k_Size + (int)middle.x];
                Assert.That(Difference(painted, Mean(a, b, c)), Is.LessThan(0.03f + 1.5f * Spread(a, b, c)));
                compared++;
            }

            Assert.That(compared, Is.GreaterThan(500));
        }

        [Test]
        public void Colours_RunOnBeyondTheEdge_SoThatFilteringFindsNoForeignOne()
        {
            SurfaceMesh square = Square(0.25f, 0.75f, new Color32(200, 100, 50, 255));
            Color32[] pixels = ColourTexture.Paint(square, 32);

            for (int y = 0; y < 32; y++)
            {
                for (int x = 0; x < 32; x++)
                {
                    int beyond = Math.Max(Math.Max(8 - x, x - 23), Math.Max(8 - y, y - 23));
                    if (beyond <= 2)
                    {
                        Assert.That(pixels[32 * y + x].r, Is.EqualTo(200), $"pixel {x}, {y}");
                    }
                    else if (beyond > 5)
                    {
                        Assert.That(pixels[32 * y + x].a, Is.Zero);
                    }
                }
            }
        }

        [Test]
        public void ATextureOfOnePixel_IsPainted()
        {
            var colour = new Color32(200, 100, 50, 255);
            Assert.That(ColourTexture.Paint(Square(0f, 1f, colour), 1)[0], Is.EqualTo(colour));
        }

        // What lies beyond the texture is left out, and nothing of it comes in at the other side.
        [Test]
        public void PlacesBeyondTheTexture_AreNotPainted()
        {
            Color32[] pixels = ColourTexture.Paint(Square(0.5f, 1.5f, new Color32(200, 100, 50, 255)), 16);

            for (int y = 0; y < 16; y++)
            {
                for (int x = 0; x < 16; x++)
                {
                    int beyond = Math.Max(8 - x, 8 - y);
                    if (beyond <= 0 || beyond > 5)
                        Assert.That(pixels[16 * y + x].a, Is.EqualTo(beyond <= 0 ? 255 : 0), $"pixel {x}, {y}");
                }
            }
        }

        [Test]
        public void ASurfaceWithoutColoursOrPlaces_AndASizeOfNothing_AreRefused()
        {
            SurfaceMesh bare = Square(0f, 1f, default);
            bare.colours = null;
            Assert.That(() => ColourTexture.Paint(bare, 8), Throws.ArgumentException.With.Message.Contains("vertex colours"));
            SurfaceMesh unmapped = Square(0f, 1f, default);
            unmapped.uvs = null;
            Assert.That(() => ColourTexture.Paint(unmapped, 8), Throws.ArgumentException.With.Message.Contains("texture coordinates"));
            Assert.That(() => ColourTexture.Paint(Square(0f, 1f, default), 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        private static SurfaceMesh Square(float from, float to, Color32 colour)
        {
            return new SurfaceMesh
            {
                positions = new Vector3[4],
                normals = new Vector3[4],
                uvs = new[] { new Vector2(from, from), new Vector2(to, from), new Vector2(to, to), new Vector2(from, to) },
                colours = new[] { colour, colour, colour, colour },
                triangles = new[] { 0, 1, 2, 0, 2, 3 },
            };
        }

        private static float Area(Vector2 a, Vector2 b, Vector2 c)
        {
            return 0.5f * k_Size * k_Size * Math.Abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        }

        private static Color Mean(Color a, Color b, Color c)
        {
            return new Color((a.r + b.r + c.r) / 3f, (a.g + b.g + c.g) / 3f, (a.b + b.b + c.b) / 3f, (a.a + b.a + c.a) / 3f);
        }

        private static float Spread(Color a, Color b, Color c) => Math.Max(Difference(a, b), Math.Max(Difference(b, c), Difference(c, a)));

        private static float Difference(Color a, Color b)
        {
            return Math.Max(Math.Max(Math.Abs(a.r - b.r), Math.Abs(a.g - b.g)), Math.Max(Math.Abs(a.b - b.b), Math.Abs(a.a - b.a)));
        }
    }
}
