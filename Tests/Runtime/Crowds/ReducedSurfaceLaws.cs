using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Crowds
{
    /// <summary>Laws of smaller meshes.</summary>
    public sealed class ReducedSurfaceLaws
    {
        [Test]
        public void APlaneWing_LosesNoArea_AndNoPlace_HoweverFewTrianglesRemain()
        {
            InsectBake bake = PlainBake.Make(5);
            ReducedSurface[] sizes = ReducedSurface.Of(bake, new[] { 100, 40, 6 });
            foreach (ReducedSurface size in sizes)
            {
                Assert.That(size.Parts[0].Length, Is.GreaterThanOrEqualTo(4 * 3), "two triangles a wing at least");
                Assert.That(Area(bake, size.Parts[0]), Is.EqualTo(2f * PlainBake.WingLength).Within(1e-4f), "of two wings of chord 1");
                Assert.That(size.Error, Is.LessThan(1e-5f), "planes that turn about their roots stay planes");
            }

            Assert.That(sizes[0].TriangleCount, Is.EqualTo(100), "no more are taken than is asked for");
            Assert.That(sizes[2].TriangleCount, Is.LessThanOrEqualTo(6));
        }

        [Test]
        public void TheError_IsTheRootOfTheMeanSquareOverVerticesAndFrames()
        {
            // All but the outermost corners of the wings rise by a hundredth of the wing length in the fifth of eight frames, which is one
            // of two that are measured.
            InsectBake bake = PlainBake.Make(1, 1, 1, 1);
            BakedFrame flat = bake.Clips[0].Frames[0];
            var frames = new List<BakedFrame>();
            for (int k = 0; k < 8; k++)
            {
                var frame = new BakedFrame(flat.Positions.Length, 4);
                bake.Surface.Positions.Select(place => (float3)place).ToArray().CopyTo(frame.Positions, 0);
                frames.Add(frame);
            }

            ReducedSurface fewest = ReducedSurface.Of(bake, new[] { 6 })[0];
            int raised = 0, all = 0;
            foreach (int vertex in bake.Wings.SelectMany(wing => wing.Vertices))
            {
                all++;
                if (fewest.Vertices.Contains(vertex))
                    continue;
                raised++;
                frames[4].Positions[vertex].y += 0.01f * PlainBake.WingLength;
            }

            bake.Clips = new[] { new BakedClip { Motion = new BakeMotion("raised"), Frames = frames } };

            Assert.That(ReducedSurface.Of(bake, new[] { 6 })[0].Error, Is.EqualTo(0.01f * math.sqrt(0.5f * raised / all)).Within(1e-6f));
        }

        [Test]
        public void SmallPieces_GoFirst_ButOnlyWhileTooManyTrianglesRemain()
        {
            InsectBake bake = PlainBake.Make(1);
            TriangleReducer reducer = ReducedSurface.Reducer(bake.Surface);
            reducer.DropPieces(1.7f, 0);
            Assert.That(reducer.Count, Is.EqualTo(130), "the body is 1.81 long, the wings are 2.2 from corner to corner");
            reducer.DropPieces(1.9f, 130);
            Assert.That(reducer.Count, Is.EqualTo(130), "few enough");
            reducer.DropPieces(1.9f, 129);
            Assert.That(reducer.Count, Is.EqualTo(128));
            Assert.That(reducer.Parts()[1], Is.Empty);
            bool[] stays = new bool[bake.Surface.Positions.Length];
            foreach (int vertex in bake.Wings.SelectMany(wing => wing.Vertices))
                stays[vertex] = true;
            reducer.DropPieces(2.5f, 0, stays);
            Assert.That(reducer.Count, Is.EqualTo(128), "wings that stay");
            reducer.DropPieces(2.5f, 100);
            Assert.That(reducer.Count, Is.EqualTo(64), "one wing is enough");
        }

        [Test]
        public void AlongASeam_NothingOpens()
        {
            // A corner of the body stands on a vertex in the middle of the wing.
            InsectBake bake = PlainBake.Make(1);
            Vector3[] places = bake.Surface.Positions;
            places[places.Length - 1] = places[22];
            TriangleReducer seam = ReducedSurface.Reducer(bake.Surface);
            seam.ReduceTo(4);

            int[] used = seam.Parts()[0];
            Assert.That(used, Does.Contain(22), "another vertex stands on its place");
        }

        private static float Area(InsectBake bake, int[] triangles)
        {
            float area = 0f;
            for (int k = 0; k < triangles.Length; k += 3)
            {
                float3 a = bake.Surface.Positions[triangles[k]], b = bake.Surface.Positions[triangles[k + 1]],
                    c = bake.Surface.Positions[triangles[k + 2]];
                area += 0.5f * math.cross(b - a, c - a).y;
            }

            return area;
        }
    }
}
