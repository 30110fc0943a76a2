using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>Sorts triangles into pieces that hang together by their corners.</summary>
    internal static class SheetPieces
    {
        /// <summary>The pieces, the one with the largest area first.</summary>
        /// <param name="points">[place]</param>
        /// <param name="triangles">Places.</param>
        /// <param name="junctions">Pairs of places that hang together too.</param>
        public static List<List<int3>> Of(float3[] points, IReadOnlyList<int3> triangles, List<(int A, int B)> junctions)
        {
            var joined = new DisjointSets(points.Length);
            foreach (int3 t in triangles)
            {
                joined.Join(t.x, t.y);
                joined.Join(t.x, t.z);
            }

            foreach ((int a, int b) in junctions)
                joined.Join(a, b);

            var numbers = new Dictionary<int, int>();
            var pieces = new List<List<int3>>();
            foreach (int3 t in triangles)
            {
                int root = joined.Find(t.x);
                if (!numbers.TryGetValue(root, out int piece))
                {
                    numbers.Add(root, piece = pieces.Count);
                    pieces.Add(new List<int3>());
                }

                pieces[piece].Add(t);
            }

            var areas = new Dictionary<List<int3>, double>();
            foreach (List<int3> piece in pieces)
                areas.Add(piece, Area(points, piece));
            pieces.Sort((a, b) => areas[b].CompareTo(areas[a]));
            return pieces;
        }

        /// <summary>Area of triangles in space.</summary>
        public static double Area(float3[] points, IReadOnlyList<int3> triangles)
        {
            double doubled = 0.0;
            foreach (int3 t in triangles)
                doubled += math.length(math.cross(points[t.y] - points[t.x], points[t.z] - points[t.x]));
            return 0.5 * doubled;
        }
    }
}
