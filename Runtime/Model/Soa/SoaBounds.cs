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
        public void Encapsulate(in SoaFloat3 p)
        {
            min = new SoaFloat3(Lower(min.x, p.x), Lower(min.y, p.y), Lower(min.z, p.z));
            max = new SoaFloat3(Higher(max.x, p.x), Higher(max.y, p.y), Higher(max.z, p.z));
        }

        // math.min and max look whether an argument is no number, which a bound never is.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Lower(float4 bound, float4 p) => math.select(bound, p, p < bound);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Higher(float4 bound, float4 p) => math.select(bound, p, p > bound);
    }
}
