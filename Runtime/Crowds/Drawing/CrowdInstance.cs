using System.Runtime.InteropServices;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// An insect of a call with motion, 128 bytes. <c>Graphics.RenderMeshInstanced</c> finds the fields by these names.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct CrowdInstance
    {
        /// <summary>Insect to world.</summary>
        public Matrix4x4 objectToWorld;

        /// <summary>Insect to world in the last frame.</summary>
        public Matrix4x4 prevObjectToWorld;
    }
}
