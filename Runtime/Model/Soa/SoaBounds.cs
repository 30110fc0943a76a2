using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Four bounding boxes, one per lane, that grow around points.</summary>
    internal struct SoaBounds
    {
        public SoaFloat3 min;
        public SoaFloat3 max;

        /// <summary>Bounds that contain nothing.</summary>
        public static SoaBounds Empty => new SoaBounds
        {
            min = new SoaFloat3(new float3(float.MaxValue)),
            max = new SoaFloat3(new float3(float.MinValue)),
        };

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Encapsulate(in SoaFloat3 p) => Encapsulate(p, p);

        /// <summary>Grows around other bounds, which may be empty.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Encapsulate(in SoaFloat3 least, in SoaFloat3 most)
        {
            min = new SoaFloat3(Lower(min.x, least.x), Lower(min.y, least.y), Lower(min.z, least.z));
            max = new SoaFloat3(Higher(max.x, most.x), Higher(max.y, most.y), Higher(max.z, most.z));
        }

        // math.min and max look whether an argument is no number, which a bound never is.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Lower(float4 bound, float4 p) => math.select(bound, p, p < bound);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Higher(float4 bound, float4 p) => math.select(bound, p, p > bound);
    }
}
