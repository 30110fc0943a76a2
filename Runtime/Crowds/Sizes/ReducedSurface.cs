using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>A smaller mesh of a baked insect, of some of its vertices, and how far it is from the whole one over all frames.</summary>
    internal sealed class ReducedSurface
    {
        /// <summary>
        /// Extent of pieces that are dropped from a mesh of one triangle, wing lengths; it falls with the root of their number, as edges
        /// do: hairs, feet and, at last, legs. Wings stay.
        /// </summary>
        private const float k_Piece = 3.5f;

        /// <summary>Every so many frames are measured.</summary>
        private const int k_Stride = 4;

        private ReducedSurface(int[][] parts, int[] vertices, float error)
        {
            Parts = parts;
            Vertices = vertices;
            Error = error;
        }

        /// <summary>[part] Three vertices of the whole surface a triangle.</summary>
        public int[][] Parts { get; }

        /// <summary>Vertices in use, ascending.</summary>
        public int[] Vertices { get; }

        /// <summary>
        /// Distance of the vertices of the wings from the smaller mesh over the frames, root of the mean square, wing lengths.
        /// </summary>
        public float Error { get; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount
        {
            get
            {
                int corners = 0;
                foreach (int[] part in Parts)
                    corners += part.Length;
                return corners / 3;
            }
        }

        /// <summary>Makes smaller meshes, each of vertices of the one before.</summary>
        /// <param name="bake">The insect.</param>
        /// <param name="triangles">[size] Triangles wanted, descending.</param>
        public static ReducedSurface[] Of(InsectBake bake, IReadOnlyList<int> triangles)
        {
            TriangleReducer reducer = Reducer(bake.Surface);
            bool[] onWings = new bool[bake.Surface.Positions.Length];
            foreach (BakedWing wing in bake.Wings)
            {
                foreach (int vertex in wing.Vertices)
                    onWings[vertex] = true;
            }

            var sizes = new ReducedSurface[triangles.Count];
            for (int size = 0; size < sizes.Length; size++)
            {
                reducer.DropPieces(k_Piece * bake.WingLength / math.sqrt(triangles[size]), triangles[size], onWings);
                reducer.ReduceTo(triangles[size]);
                int[][] parts = reducer.Parts();
                sizes[size] = new ReducedSurface(parts, Used(parts), Measure(bake, parts));
            }

            return sizes;
        }

        /// <summary>Makes a reducer of a surface at rest.</summary>
        internal static TriangleReducer Reducer(BakedSurface surface) => new TriangleReducer(
            Array.ConvertAll(surface.Positions, place => (float3)place), surface.Parts.Select(part => part.Triangles).ToArray());

        private static int[] Used(int[][] parts)
        {
            var used = new SortedSet<int>();
            foreach (int[] part in parts)
                used.UnionWith(part);
            int[] vertices = new int[used.Count];
            used.CopyTo(vertices);
            return vertices;
        }

        private static float Measure(InsectBake bake, int[][] parts)
        {
            double sum = 0.0;
            long count = 0;
            foreach (BakedWing wing in bake.Wings)
            {
                List<RestTriangle> triangles = TrianglesOf(bake.Surface, wing, parts);
                foreach (int vertex in wing.Vertices)
                {
                    (int3 corners, float3 shares) = Nearest(triangles, bake.Surface.Positions[vertex]);
                    foreach (BakedClip clip in bake.Clips)
                    {
                        for (int frame = 0; frame < clip.Frames.Count; frame += k_Stride)
                        {
                            float3[] places = clip.Frames[frame].Positions;
                            float3 carried = shares.x * places[corners.x] + shares.y * places[corners.y] + shares.z * places[corners.z];
                            sum += math.distancesq(carried, places[vertex]) / (wing.Length * wing.Length);
                            count++;
                        }
                    }
                }
            }

            return (float)Math.Sqrt(sum / Math.Max(count, 1));
        }

        private static List<RestTriangle> TrianglesOf(BakedSurface surface, BakedWing wing, int[][] parts)
        {
            var vertices = new HashSet<int>(wing.Vertices);
            var triangles = new List<RestTriangle>();
            foreach (int[] part in parts)
            {
                for (int k = 0; k < part.Length; k += 3)
                {
                    if (vertices.Contains(part[k]))
                        triangles.Add(new RestTriangle(surface, new int3(part[k], part[k + 1], part[k + 2])));
                }
            }

            return triangles;
        }

        // The place on the triangles that is nearest to a point at rest, by its shares in the corners.
        private static (int3 Corners, float3 Shares) Nearest(List<RestTriangle> triangles, float3 point)
        {
            (int3 Corners, float3 Shares) nearest = (Corners: int3.zero, Shares: float3.zero);
            float least = float.PositiveInfinity;
            foreach (RestTriangle triangle in triangles)
            {
                if (triangle.IsBeyond(point, least))
                    continue;
                float3 shares = NearestShares(point, triangle.a, triangle.b, triangle.c);
                float distance = math.distancesq(point, shares.x * triangle.a + shares.y * triangle.b + shares.z * triangle.c);
                if (distance < least)
                    (least, nearest) = (distance, (triangle.corners, shares));
            }

            return nearest;
        }

        /// <summary>Shares of the corners in the place on a triangle that is nearest to a point.</summary>
        internal static float3 NearestShares(float3 point, float3 a, float3 b, float3 c)
        {
            float3 ab = b - a, ac = c - a, ap = point - a;
            float xx = math.dot(ab, ab), xy = math.dot(ab, ac), yy = math.dot(ac, ac), px = math.dot(ap, ab), py = math.dot(ap, ac);
            float area = xx * yy - xy * xy;
            float u = (yy * px - xy * py) / area, v = (xx * py - xy * px) / area;

            // Of a triangle without area the shares are no numbers, or endless: then its edges count.
            if (u >= 0f && v >= 0f && u + v <= 1f)
                return new float3(1f - u - v, u, v);
            float3 onAb = OnEdge(px, xx, 1), onAc = OnEdge(py, yy, 2);
            float t = math.saturate(math.dot(point - b, c - b) / math.max(math.lengthsq(c - b), 1e-20f));
            var onBc = new float3(0f, 1f - t, t);
            float toAb = Away(point, onAb, a, b, c), toAc = Away(point, onAc, a, b, c), toBc = Away(point, onBc, a, b, c);
            return toAb <= toAc && toAb <= toBc ? onAb : toAc <= toBc ? onAc : onBc;
        }

        private static float3 OnEdge(float along, float length2, int corner)
        {
            float t = math.saturate(along / math.max(length2, 1e-20f));
            return corner == 1 ? new float3(1f - t, t, 0f) : new float3(1f - t, 0f, t);
        }

        private static float Away(float3 point, float3 shares, float3 a, float3 b, float3 c) =>
            math.distancesq(point, shares.x * a + shares.y * b + shares.z * c);

        private readonly struct RestTriangle
        {
            /// <summary>Share of a distance that rounding cannot make up for.</summary>
            private const float k_Surely = 0.9999f;

            public readonly int3 corners;
            public readonly float3 a, b, c;
            private readonly float m_Radius;

            public RestTriangle(BakedSurface surface, int3 corners)
            {
                this.corners = corners;
                (a, b, c) = (surface.Positions[corners.x], surface.Positions[corners.y], surface.Positions[corners.z]);
                m_Radius = math.sqrt(math.max(math.distancesq(a, b), math.distancesq(a, c)));
            }

            /// <summary>Returns true where all of it is farther from a point than the root of a number.</summary>
            public bool IsBeyond(float3 point, float squared)
            {
                float gap = k_Surely * math.distance(point, a) - m_Radius;
                return gap > 0f && k_Surely * gap * gap > squared;
            }
        }
    }
}
