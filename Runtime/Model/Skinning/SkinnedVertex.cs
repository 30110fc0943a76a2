using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>A deformed vertex as it lies in the mesh's first vertex stream: 24 bytes, mesh space.</summary>
    [StructLayout(LayoutKind.Sequential)]
    [MovedFrom(true, null, "Alate")]
    public struct SkinnedVertex
    {
        /// <summary>Position, mesh units.</summary>
        public float3 position;

        /// <summary>Normal, not exactly unit length: within 1e-6.</summary>
        public float3 normal;
    }
}
