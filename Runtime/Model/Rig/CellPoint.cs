using Unity.Mathematics;

namespace Alate
{
    /// <summary>A point of the wing by its cell of the skeleton and its bilinear coordinates there.</summary>
    internal struct CellPoint
    {
        /// <summary>Cell index.</summary>
        public int cell;

        /// <summary>Coordinate across the chains, 0 on the forward chain, in [0, 1].</summary>
        public float u;

        /// <summary>Coordinate along the chains, 0 at the inner joints, in [0, 1].</summary>
        public float v;

        /// <summary>Distance in plan from the point that (u, v) names; 0 inside the cell. Wing lengths.</summary>
        public float distance;

        /// <summary>Weights of the cell's joints (i, j), (i, j+1), (i+1, j), (i+1, j+1); their sum is 1.</summary>
        public float4 Weights => new float4((1f - u) * (1f - v), (1f - u) * v, u * (1f - v), u * v);

        /// <summary>Numbers points cell by cell; within a cell they keep their order.</summary>
        /// <param name="points">The points.</param>
        /// <param name="cellCount">Number of cells.</param>
        /// <param name="firsts">[cell] The cell's first number; one more entry holds the number of points.</param>
        /// <returns>The number of each point.</returns>
        public static int[] Ranks(CellPoint[] points, int cellCount, out int[] firsts)
        {
            firsts = new int[cellCount + 1];
            foreach (CellPoint point in points)
                firsts[point.cell + 1]++;
            for (int cell = 0; cell < cellCount; cell++)
                firsts[cell + 1] += firsts[cell];
            int[] next = (int[])firsts.Clone();
            return System.Array.ConvertAll(points, point => next[point.cell]++);
        }
    }
}
