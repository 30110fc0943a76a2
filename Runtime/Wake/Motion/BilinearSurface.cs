using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>Surface through rows of points, such as chains of joints; bilinear between four of them.</summary>
    internal readonly struct BilinearSurface
    {
        private readonly int m_Rows, m_Columns;

        /// <summary>Surface through a number of points.</summary>
        /// <param name="rows">Rows from the leading to the trailing edge, 2 or more.</param>
        /// <param name="columns">Points of a row from the root to the tip, 2 or more.</param>
        public BilinearSurface(int rows, int columns)
        {
            m_Rows = rows;
            m_Columns = columns;
        }

        /// <summary>Number of points.</summary>
        public int Count => m_Rows * m_Columns;

        /// <summary>Value at a place.</summary>
        /// <param name="values">[row · columns + column]</param>
        /// <param name="place">x: 0 at the leading to 1 at the trailing edge; y: 0 at the root to 1 at the tip.</param>
        public float3 At(float3[] values, float2 place)
        {
            float2 at = place * new float2(m_Rows - 1, m_Columns - 1);
            int row = math.clamp((int)at.x, 0, m_Rows - 2), column = math.clamp((int)at.y, 0, m_Columns - 2);
            int corner = row * m_Columns + column;
            float v = at.y - column;
            return math.lerp(
                math.lerp(values[corner], values[corner + 1], v),
                math.lerp(values[corner + m_Columns], values[corner + m_Columns + 1], v), at.x - row);
        }
    }
}
