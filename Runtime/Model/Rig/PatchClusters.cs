using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Assigns triangles to patches. Patches are numbered cell by cell.</summary>
    internal static class PatchClusters
    {
        /// <summary>Makes every triangle a patch of its own.</summary>
        /// <param name="rest">The skeleton.</param>
        /// <param name="located">Where the centres of the triangles lie.</param>
        /// <param name="firsts">[cell] Its first patch; one more entry holds their number.</param>
        /// <returns>The patch of each triangle.</returns>
        public static int[] OnePerTriangle(RestSkeleton rest, CellPoint[] located, out int[] firsts) =>
            CellPoint.Ranks(located, rest.CellCount, out firsts);

        /// <summary>
        /// Sorts the triangles of each cell by their centres into a grid over (u, v). Cells get their share of the wanted number by area,
        /// and at least one; the grid's rows run across the chains and are about as long as they are wide.
        /// </summary>
        /// <inheritdoc cref="OnePerTriangle"/>
        public static int[] Make(RestSkeleton rest, SurfaceTriangles triangles, CellPoint[] located, int wanted, out int[] firsts)
        {
            double[] areas = new double[rest.CellCount];
            for (int t = 0; t < triangles.Count; t++)
                areas[located[t].cell] += triangles.areas[t];

            var grids = new Grid[rest.CellCount];
            int bins = 0;
            for (int cell = 0; cell < grids.Length; cell++)
            {
                int share = Math.Max(1, (int)Math.Round(wanted * areas[cell] / triangles.Area));
                grids[cell] = new Grid(rest, cell, share, bins);
                bins += share;
            }

            int[] patches = new int[triangles.Count];
            int[] used = new int[bins + 1];
            for (int t = 0; t < triangles.Count; t++)
            {
                patches[t] = grids[located[t].cell].BinOf(located[t]);
                used[patches[t] + 1] = 1;
            }

            // From bin to patch: the number of bins before it that hold a triangle.
            for (int bin = 0; bin < bins; bin++)
                used[bin + 1] += used[bin];
            for (int t = 0; t < patches.Length; t++)
                patches[t] = used[patches[t]];
            firsts = new int[grids.Length + 1];
            for (int cell = 0; cell < grids.Length; cell++)
                firsts[cell] = used[grids[cell].firstBin];
            firsts[grids.Length] = used[bins];
            return patches;
        }

        /// <summary>A cell cut into a number of bins: rows along v, each cut along u so that the bins add up.</summary>
        private readonly struct Grid
        {
            public readonly int firstBin;
            private readonly int m_Bins;
            private readonly int m_Rows;

            public Grid(RestSkeleton rest, int cell, int bins, int firstBin)
            {
                int joint = rest.FirstJoint(cell), next = joint + rest.jointsPerChain;
                float3 p00 = rest.joints[joint], p01 = rest.joints[joint + 1], p10 = rest.joints[next], p11 = rest.joints[next + 1];
                float along = math.distance(p00, p01) + math.distance(p10, p11);
                float across = math.distance(p00, p10) + math.distance(p01, p11);
                this.firstBin = firstBin;
                m_Bins = bins;
                m_Rows = math.clamp((int)math.round(math.sqrt(bins * along / across)), 1, bins);
            }

            public int BinOf(CellPoint at)
            {
                int row = math.min((int)(at.v * m_Rows), m_Rows - 1);
                int before = row * m_Bins / m_Rows, columns = (row + 1) * m_Bins / m_Rows - before;
                return firstBin + before + math.min((int)(at.u * columns), columns - 1);
            }
        }
    }
}
