using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>A deformed vertex as it lies in the first vertex stream of a living mesh: 16 bytes, mesh space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct PackedVertex
    {
        /// <summary>Position, mesh units.</summary>
        public float3 position;

        /// <summary>Normal by <see cref="SignedBytes"/>.</summary>
        public int normal;
    }
}
