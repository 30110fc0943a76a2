using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>Sorts triangles into pieces that hang together by their corners.</summary>
    internal sealed class SheetPieces
    {
        private readonly int[] m_Parents;

        private SheetPieces(int places)
        {
            m_Parents = new int[places];
            for (int k = 0; k < places; k++)
                m_Parents[k] = k;
        }

        /// <summary>The pieces, the one with the largest area first.</summary>
        /// <param name="points">[place]</param>
        /// <param name="triangles">Places.</param>
        /// <param name="junctions">Pairs of places that hang together too.</param>
        public static List<List<int3>> Of(float3[] points, IReadOnlyList<int3> triangles, List<(int A, int B)> junctions)
        {
            var joined = new SheetPieces(points.Length);
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
                int root = joined.Root(t.x);
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

        private void Join(int a, int b)
        {
            int first = Root(a), second = Root(b);
            if (first < second)
                m_Parents[second] = first;
            else
                m_Parents[first] = second;
        }

        private int Root(int place)
        {
            while (m_Parents[place] != place)
            {
                m_Parents[place] = m_Parents[m_Parents[place]];
                place = m_Parents[place];
            }

            return place;
        }
    }
}
