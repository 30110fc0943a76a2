using System;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>One of the meshes of a baked insect.</summary>
    [Serializable]
    public struct CrowdSize
    {
        /// <summary>The mesh; its second texture coordinates find each vertex in the texture.</summary>
        public Mesh mesh;

        /// <summary>Triangles of the mesh.</summary>
        public int triangles;

        /// <summary>Distance of the whole wings from this mesh over all loops, root of the mean square, wing lengths.</summary>
        public float error;

        /// <summary>Height on the screen up to which the mesh is fine enough: the insect's radius over half the screen's height.</summary>
        public float screenHeight;
    }
}
