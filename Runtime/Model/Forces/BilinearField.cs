using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// A vector that varies bilinearly over a skeleton cell: f(u, v) = c + u·cu + v·(cv + u·cuv); u across chains, v along.
    /// </summary>
    internal unsafe struct BilinearField
    {
        private SoaFloat3 m_C, m_U, m_V, m_UV;

        /// <summary>Makes a field from the values at the four joints of a cell.</summary>
        /// <param name="field">To fill.</param>
        /// <param name="values">[joint]</param>
        /// <param name="joint">First joint of the cell.</param>
        /// <param name="next">The joint beside it on the next chain.</param>
        public static void Gather(BilinearField* field, SoaFloat3* values, int joint, int next)
        {
            SoaFloat3 at00 = values[joint];
            SoaFloat3 alongV = values[joint + 1] - at00;
            field->m_C = at00;
            field->m_V = alongV;
            field->m_U = values[next] - at00;
            field->m_UV = values[next + 1] - values[next] - alongV;
        }

        /// <summary>The value at (u, v).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 At(BilinearField* f, float4 u, float4 v) => f->m_C + f->m_U * u + (f->m_V + f->m_UV * u) * v;
    }
}
