using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Triangulates a right wing's outline in the plane y = 0, facing up: span along X from the hinge line, leading edge towards +Z, one
    /// wing length long times <c>scale</c>. Texture coordinates: u along the span, v from the rearmost to the foremost point of the
    /// outline. The same input gives the same mesh, bit for bit.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public static class WingMesher
    {
        /// <summary>Fewest triangles <see cref="Strips"/> and <see cref="Fill(WingOutline, int, float)"/> make.</summary>
        public const int MinTriangles = 50;

        /// <summary>Most triangles <see cref="Strips"/> and <see cref="Fill(WingOutline, int, float)"/> make.</summary>
        public const int MaxTriangles = 1000000;

        /// <summary>
        /// A regular grid: stations evenly along the span, vertices evenly along each chord from leading to trailing edge. Vertex (k, c)
        /// has the index k (chordCells + 1) + c. For experiments: triangles are as narrow as the chord
        /// at their station, and vanish in the tip of a rounded one.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">A count is below 1.</exception>
        public static SurfaceMesh Grid(WingOutline outline, int spanCells, int chordCells, float scale = 1f)
        {
            if (outline == null)
                throw new ArgumentNullException(nameof(outline));

            if (spanCells < 1 || chordCells < 1)
            {
                throw new ArgumentOutOfRangeException(
                    spanCells < 1 ? nameof(spanCells) : nameof(chordCells), Math.Min(spanCells, chordCells),
                    "A grid has at least one cell each way.");
            }

            int[] segments = new int[spanCells + 1];
            double[] spans = new double[spanCells + 1];
            for (int k = 0; k <= spanCells; k++)
            {
                segments[k] = chordCells;
                spans[k] = (double)k / spanCells;
            }

            return Mesh(outline, spans, segments, scale);
        }

        /// <summary>
        /// An even mesh of an exact number of triangles: the chord of every station is cut into pieces of nearly one size, and neighbouring
        /// stations are stitched along the shorter diagonals.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is not between <see cref="MinTriangles"/> and
        /// <see cref="MaxTriangles"/>.</exception>
        public static SurfaceMesh Strips(WingOutline outline, int triangleCount, float scale = 1f)
        {
            Check(outline, triangleCount);

            int[] segments = ChordSegments.For(outline, triangleCount, out double[] spans);
            return Mesh(outline, spans, segments, scale);
        }

        /// <summary>
        /// Makes an even mesh of an exact number of triangles whose vertices follow the rim and lie on a lattice of equilateral triangles
        /// inside it: for outlines that are too steep for stations, such as a tail or a fan.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The count is not between <see cref="MinTriangles"/> and
        /// <see cref="MaxTriangles"/>.</exception>
        public static SurfaceMesh Fill(WingOutline outline, int triangleCount, float scale = 1f) =>
            Fill(outline, null, triangleCount, scale);

        /// <summary>Mesh of an outline with a scalloped margin; null for none.</summary>
        internal static SurfaceMesh Fill(WingOutline outline, RimScallops scallops, int triangleCount, float scale)
        {
            Check(outline, triangleCount);
            PlanPoint[] rim = WingRim.Of(outline, scallops, out List<int> corners);
            TriangleLinks mesh = OutlineMesher.Mesh(rim, triangleCount, out _, corners);
            Vector3[] positions = Array.ConvertAll(
                mesh.points, point => new Vector3((float)(point.x * scale), 0f, (float)(point.z * scale)));
            return Surface(outline, positions, mesh.Clockwise(), scale);
        }

        private static SurfaceMesh Mesh(WingOutline outline, double[] spans, int[] segments, float scale)
        {
            Vector3[] positions = StationVertices(outline, spans, segments, scale);
            return Surface(outline, positions, StripStitcher.Stitch(positions, segments), scale);
        }

        private static SurfaceMesh Surface(WingOutline outline, Vector3[] positions, int[] triangles, float scale)
        {
            var normals = new Vector3[positions.Length];
            Array.Fill(normals, new Vector3(0f, 1f, 0f));
            return new SurfaceMesh
            {
                positions = positions,
                normals = normals,
                uvs = TextureCoordinates(outline, positions, scale),
                triangles = triangles,
            };
        }

        private static Vector3[] StationVertices(WingOutline outline, double[] spans, int[] segments, float scale)
        {
            var positions = new Vector3[StripStitcher.CountVertices(segments)];
            int vertex = 0;
            for (int station = 0; station < segments.Length; station++)
            {
                double span = spans[station];
                double leading = outline.LeadingAt(span);
                double trailing = outline.TrailingAt(span);
                for (int c = 0; c <= segments[station]; c++)
                {
                    double z = segments[station] == 0 ? 0.5 * (leading + trailing) : leading + (trailing - leading) * c / segments[station];
                    positions[vertex++] = new Vector3((float)(span * scale), 0f, (float)(z * scale));
                }
            }

            return positions;
        }

        private static Vector2[] TextureCoordinates(WingOutline outline, Vector3[] positions, float scale)
        {
            float rear = (float)outline.Rear;
            float depth = (float)(outline.Front - outline.Rear);
            return Array.ConvertAll(positions, p => new Vector2(p.x / scale, (p.z / scale - rear) / depth));
        }

        private static void Check(WingOutline outline, int triangleCount)
        {
            if (outline == null)
                throw new ArgumentNullException(nameof(outline));

            if (triangleCount < MinTriangles || triangleCount > MaxTriangles)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(triangleCount), triangleCount, $"A wing is meshed with {MinTriangles} to {MaxTriangles} triangles.");
            }
        }
    }
}
