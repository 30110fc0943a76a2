using Unity.Collections;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Memory for the joints of many wings, which may lie elsewhere in the next picture.</summary>
    internal interface IJointMemory
    {
        /// <summary>Two of four floats a joint, the dual quaternion of its transform; not created before there are any.</summary>
        NativeArray<float4> Texels { get; }
    }
}
