using System.Collections.Generic;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>All that is drawn of an insect at rest as one mesh, in the insect's own space: X right, Y up, Z ahead.</summary>
    public sealed class BakedSurface
    {
        /// <summary>[vertex] Position at rest.</summary>
        public Vector3[] Positions { get; internal set; }

        /// <summary>[vertex] Unit normal at rest.</summary>
        public Vector3[] Normals { get; internal set; }

        /// <summary>[vertex] Texture coordinates; zero where a mesh has none.</summary>
        public Vector2[] Uvs { get; internal set; }

        /// <summary>[vertex] Colour; white where a mesh has none.</summary>
        public Color32[] Colours { get; internal set; }

        /// <summary>Parts by material, in the order in which they are drawn.</summary>
        public IReadOnlyList<BakedPart> Parts { get; internal set; }

        /// <summary>Number of vertices.</summary>
        public int VertexCount => Positions.Length;

        /// <summary>Number of triangles.</summary>
        public int TriangleCount
        {
            get
            {
                int count = 0;
                foreach (BakedPart part in Parts)
                    count += part.Triangles.Length / 3;
                return count;
            }
        }
    }
}
