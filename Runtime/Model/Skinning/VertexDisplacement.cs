using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Way of a deformed vertex since the last picture, as it lies in the last vertex stream of a living mesh: four halves, 8 bytes, mesh
    /// units. What Unity's shaders call a precomputed velocity: it leads from where the vertex was to where it is.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct VertexDisplacement
    {
        /// <summary>Halves x and y, x in the lower bits.</summary>
        public uint xy;

        /// <summary>Halves z and 0.</summary>
        public uint z;

        /// <summary>Packs four displacements: x and y of each.</summary>
        public static uint4 PackXY(in SoaFloat3 displacement) => math.f32tof16(displacement.x) | (math.f32tof16(displacement.y) << 16);

        /// <summary>Packs four displacements: z of each.</summary>
        public static uint4 PackZ(in SoaFloat3 displacement) => math.f32tof16(displacement.z);
    }
}
