using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Joins rows of vertices, each running from leading to trailing edge, by strips of triangles that face up.</summary>
    internal static class StripStitcher
    {
        public static int CountVertices(int[] segments)
        {
            int count = segments.Length;
            foreach (int pieces in segments)
                count += pieces;

            return count;
        }

        public static int[] Stitch(Vector3[] positions, int[] segments)
        {
            int[] triangles = new int[3 * ChordSegments.CountTriangles(segments)];
            int corner = 0;
            int inner = 0;
            for (int k = 0; k + 1 < segments.Length; k++)
            {
                int outer = inner + segments[k] + 1;
                corner = StitchStrip(positions, inner, segments[k], outer, segments[k + 1], triangles, corner);
                inner = outer;
            }

            return triangles;
        }

        private static int StitchStrip(
            Vector3[] positions, int inner, int innerPieces, int outer, int outerPieces, int[] triangles, int corner)
        {
            int a = inner;
            int b = outer;
            while (a < inner + innerPieces || b < outer + outerPieces)
            {
                bool advanceInner = a < inner + innerPieces
                    && (b == outer + outerPieces || SquaredDistance(positions, a + 1, b) <= SquaredDistance(positions, a, b + 1));
                triangles[corner++] = a;
                triangles[corner++] = b;
                triangles[corner++] = advanceInner ? ++a : b + 1;
                b = advanceInner ? b : b + 1;
            }

            return corner;
        }

        private static float SquaredDistance(Vector3[] positions, int a, int b) => (positions[a] - positions[b]).sqrMagnitude;
    }
}
