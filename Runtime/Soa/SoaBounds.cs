using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Four bounding boxes, one per lane, that grow around points.</summary>
    internal struct SoaBounds
    {
        public SoaFloat3 min;
        public SoaFloat3 max;

        /// <summary>Around nothing.</summary>
        public static SoaBounds Empty => new SoaBounds
        {
            min = new SoaFloat3(new float3(float.MaxValue)),
            max = new SoaFloat3(new float3(float.MinValue)),
        };

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Encapsulate(in SoaFloat3 p)
        {
            min = new SoaFloat3(math.min(min.x, p.x), math.min(min.y, p.y), math.min(min.z, p.z));
            max = new SoaFloat3(math.max(max.x, p.x), math.max(max.y, p.y), math.max(max.z, p.z));
        }
    }
}
