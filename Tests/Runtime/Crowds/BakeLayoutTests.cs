using System.Collections.Generic;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Crowds
{
    /// <summary>Places of vertices and frames in a texture.</summary>
    public sealed class BakeLayoutTests
    {
        [TestCase(10, 3, false)]
        [TestCase(5624, 49, false)]
        [TestCase(5624, 49, true)]
        [TestCase(4096, 16, true)]
        public void EveryVertexAndFrame_HasAPixelOfItsOwn(int vertices, int frames, bool holdsNormals)
        {
            var layout = BakeLayout.Fit(vertices, frames, 4096, holdsNormals);
            var taken = new HashSet<int2>();
            for (int vertex = 0; vertex < vertices; vertex++)
            {
                for (int frame = 0; frame < frames; frame++)
                {
                    int2 pixel = layout.PixelOf(vertex, frame);
                    Assert.That(taken.Add(pixel));
                    Assert.That(pixel.x >= 0 && pixel.x < layout.Width && pixel.y >= 0
                        && pixel.y < (holdsNormals ? layout.NormalRows : layout.Height));
                }
            }
        }

        [Test]
        public void Coordinates_AreThoseOfThePixelsMiddle()
        {
            var layout = BakeLayout.Fit(100, 4, 32, false);
            float2 first = layout.CoordinatesOf(0), below = layout.CoordinatesOf(layout.Width + 1);

            Assert.That(math.distance(first, new float2(0.5f / layout.Width, 1f - 0.5f / layout.Height)), Is.LessThan(1e-6f));
            Assert.That(math.distance(below, new float2(1.5f / layout.Width, 1f - 4.5f / layout.Height)), Is.LessThan(1e-6f));
        }

        [Test]
        public void ATextureThatIsTooLarge_IsRefused_WithItsSize()
        {
            Assert.That(
                () => BakeLayout.Fit(1000, 64, 128, false),
                Throws.TypeOf<BakeException>().With.Message
                    .StartsWith("1000 vertices at 64 frames need a texture of 128 x 512 pixels; at most 128 x 128 are allowed"));
        }
    }
}
