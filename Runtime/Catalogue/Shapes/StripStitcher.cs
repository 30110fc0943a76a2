using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Joins rows of vertices, each running from leading to trailing edge, by strips of triangles that face up.</summary>
    internal static class StripStitcher
    {
        public static int CountVertices(int[] segments)
        {
            var count = segments.Length;
            foreach (var pieces in segments)
                count += pieces;

            return count;
        }

        public static int[] Stitch(Vector3[] positions, int[] segments)
        {
            var triangles = new int[3 * ChordSegments.CountTriangles(segments)];
            var corner = 0;
            var inner = 0;
            for (var k = 0; k + 1 < segments.Length; k++)
            {
                var outer = inner + segments[k] + 1;
                corner = StitchStrip(positions, inner, segments[k], outer, segments[k + 1], triangles, corner);
                inner = outer;
            }

            return triangles;
        }

        private static int StitchStrip(Vector3[] positions, int inner, int innerPieces, int outer, int outerPieces, int[] triangles, int corner)
        {
            var a = inner;
            var b = outer;
            while (a < inner + innerPieces || b < outer + outerPieces)
            {
                var advanceInner = a < inner + innerPieces
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
