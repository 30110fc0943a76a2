using Unity.Mathematics;

namespace Alate
{
    /// <summary>Surface patches that meet the air, cell by cell: the triangles themselves, or clusters of triangles.</summary>
    internal sealed class PatchLayout
    {
        private const float k_LeastShare = 0.05f;

        /// <summary>[cell] Range of patches.</summary>
        public readonly PatchCell[] cells;
        public readonly float[] u;
        public readonly float[] v;
        public readonly float[] span;
        public readonly float[] chord;
        public readonly float[] areas;

        /// <summary>[patch] Quarter of the wing's chord there, L.</summary>
        public readonly float[] quarterChords;

        /// <param name="rest">The skeleton.</param>
        /// <param name="map">Its cells.</param>
        /// <param name="triangles">The wing.</param>
        /// <param name="located">Where the centres of the triangles lie.</param>
        /// <param name="chords">Chords of the wing.</param>
        /// <param name="wanted">About how many patches; 0 for one per triangle.</param>
        public PatchLayout(RestSkeleton rest, CellMap map, SurfaceTriangles triangles, CellPoint[] located, SpanChords chords, int wanted)
        {
            int[] clusters = wanted == 0 || wanted >= triangles.Count
                ? PatchClusters.OnePerTriangle(rest, located, out int[] firsts)
                : PatchClusters.Make(rest, triangles, located, wanted, out firsts);
            int count = firsts[rest.CellCount];
            areas = new float[count];
            float3[] centres = Centres(triangles, clusters, count);

            u = new float[count];
            v = new float[count];
            span = new float[count];
            chord = new float[count];
            cells = new PatchCell[rest.CellCount];
            for (int cell = 0; cell < cells.Length; cell++)
            {
                cells[cell].firstPatch = firsts[cell];
                cells[cell].patchCount = firsts[cell + 1] - firsts[cell];
                Place(map, cell, centres);
            }

            quarterChords = System.Array.ConvertAll(span, x => (float)(0.25 * chords.At(x)));
        }

        public int Count => areas.Length;

        /// <summary>
        /// [patch] 1/|p_u × p_v| of the rest cell at the centre. Where a cell ends in a point that product vanishes; there, <see
        /// cref="k_LeastShare"/> of the product in the middle replaces it, so that a patch at the point does not grow without bound.
        /// </summary>
        public float[] Measures(RestSkeleton rest)
        {
            float[] measures = new float[Count];
            for (int cell = 0; cell < cells.Length; cell++)
            {
                int joint = rest.FirstJoint(cell), next = joint + rest.jointsPerChain;
                float3 alongU = rest.joints[next] - rest.joints[joint], alongV = rest.joints[joint + 1] - rest.joints[joint];
                float3 mixed = rest.joints[next + 1] - rest.joints[next] - alongV;
                float middle = math.length(math.cross(alongU + 0.5f * mixed, alongV + 0.5f * mixed));
                for (int patch = cells[cell].firstPatch; patch < cells[cell].firstPatch + cells[cell].patchCount; patch++)
                {
                    float here = math.length(math.cross(alongU + mixed * v[patch], alongV + mixed * u[patch]));
                    measures[patch] = 1f / math.max(here, k_LeastShare * middle);
                }
            }

            return measures;
        }

        private float3[] Centres(SurfaceTriangles triangles, int[] clusters, int count)
        {
            var centres = new float3[count];
            for (int t = 0; t < triangles.Count; t++)
            {
                areas[clusters[t]] += triangles.areas[t];
                centres[clusters[t]] += triangles.areas[t] * triangles.centres[t];
            }

            for (int patch = 0; patch < count; patch++)
                centres[patch] /= areas[patch];
            return centres;
        }

        private void Place(CellMap map, int cell, float3[] centres)
        {
            int first = cells[cell].firstPatch, end = first + cells[cell].patchCount;
            for (int patch = first; patch < end; patch++)
            {
                CellPoint at = map.LocateIn(cell, centres[patch]);
                u[patch] = at.u;
                v[patch] = at.v;
                span[patch] = centres[patch].x;
                chord[patch] = centres[patch].z;
            }
        }
    }
}
