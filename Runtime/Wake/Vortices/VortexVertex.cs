using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// End of a straight vortex segment, whose start is the vertex before; 32 bytes, as two loads of four numbers. A chain of segments
    /// shares its vertices, so that each distance is computed once.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct VortexVertex
    {
        /// <summary>Place, reference lengths.</summary>
        public float3 position;

        /// <summary>Γ/4π of the segment that ends here; 0 where a chain begins.</summary>
        public float strength;

        /// <summary>r0: from the start of the segment to its end.</summary>
        public float3 along;

        /// <summary>rc⁴ |r0|⁴ of the segment.</summary>
        public float core;

        /// <summary>A segment from one place to another.</summary>
        /// <param name="from">Its start, which is the vertex before.</param>
        /// <param name="to">Its end.</param>
        /// <param name="circulation">Γ, squared reference lengths a beat.</param>
        /// <param name="coreSquare">Square of the core's radius.</param>
        public static VortexVertex Segment(float3 from, float3 to, float circulation, float coreSquare)
        {
            float3 along = to - from;
            float core = coreSquare * math.lengthsq(along);
            return new VortexVertex { position = to, strength = circulation / (4f * math.PI), along = along, core = core * core };
        }
    }
}
