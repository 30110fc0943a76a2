using Unity.Mathematics;

namespace Alate
{
    /// <summary>The patches of one cell and the rest frame they share; wing frame, wing lengths.</summary>
    internal struct PatchCell
    {
        public int firstPatch;
        public int patchCount;

        /// <summary>Area-weighted mean of the patch centres; middle of the cell's joints where there is no patch.</summary>
        public float3 origin;

        /// <summary>The wing's span axis made perpendicular to <see cref="normal"/>.</summary>
        public float3 span;

        /// <summary>cross(span, normal): forward on a flat wing.</summary>
        public float3 chord;

        /// <summary>Area-weighted mean rest normal, dorsal side.</summary>
        public float3 normal;
    }
}
