using System;
using System.IO;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>The triangles of a Wavefront OBJ file.</summary>
    internal sealed class ObjMesh
    {
        /// <summary>[vertex] From <see cref="Origin"/>.</summary>
        public Vector3[] Positions { get; set; }

        /// <summary>
        /// Origin from which the positions are counted, in the file's space: zero, and for a mesh far from the file's origin its middle, so
        /// that its shape is not lost in single precision.
        /// </summary>
        public (double X, double Y, double Z) Origin { get; set; }

        /// <summary>[vertex] Null unless every corner of the file has one.</summary>
        public Vector3[] Normals { get; set; }

        /// <summary>[vertex] Null unless every vertex of the file has one.</summary>
        public Color32[] Colours { get; set; }

        /// <summary>[vertex] Null unless every corner of the file has one.</summary>
        public Vector2[] Uvs { get; set; }

        public int[] Triangles { get; set; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => Triangles.Length / 3;

        /// <summary>File of the materials as the mesh names it; null where it names none.</summary>
        public string Library { get; set; }

        /// <summary>True for the name of such a file.</summary>
        public static bool IsNamed(string file) => string.Equals(Path.GetExtension(file), ".obj", StringComparison.OrdinalIgnoreCase);

        /// <summary>A place in the file's space as positions are counted, from <see cref="Origin"/>; null for none.</summary>
        public Vector3? Placed(double[] place) => place is { Length: 3 }
            ? new Vector3((float)(place[0] - Origin.X), (float)(place[1] - Origin.Y), (float)(place[2] - Origin.Z))
            : (Vector3?)null;

        public SurfaceMesh ToSurface(string name) =>
            new SurfaceMesh { name = name, positions = Positions, normals = Normals, uvs = Uvs, triangles = Triangles };
    }
}
