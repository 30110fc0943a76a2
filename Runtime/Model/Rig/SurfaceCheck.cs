using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Refuses surfaces that no rig can be baked from, with one line that names the fault.</summary>
    internal static class SurfaceCheck
    {
        public static void Run(SurfaceMesh surface)
        {
            if (surface == null)
                throw new ArgumentNullException(nameof(surface));
            string name = Name(surface);
            if (surface.positions == null || surface.positions.Length == 0)
                throw new ArgumentException($"{name} has no vertices.");
            if (surface.triangles == null || surface.triangles.Length == 0)
                throw new ArgumentException($"{name} has no triangles.");
            if (surface.triangles.Length % 3 != 0)
                throw new ArgumentException($"{name} has {surface.triangles.Length} indices, which is not a multiple of three.");
            int vertices = surface.positions.Length;
            CheckLength(name, "normals", surface.normals?.Length ?? 0, vertices);
            CheckLength(name, "tangents", surface.tangents?.Length ?? 0, vertices);
            for (int k = 0; k < surface.triangles.Length; k++)
            {
                int index = surface.triangles[k];
                if (index < 0 || index >= vertices)
                    throw new ArgumentException($"{name}: triangle {k / 3} refers to vertex {index}, but there are {vertices} vertices.");
            }

            for (int k = 0; k < vertices; k++)
            {
                if (!math.all(math.isfinite((float3)surface.positions[k])))
                    throw new ArgumentException($"{name}: the position of vertex {k} is not finite.");
            }
        }

        /// <summary>Name of a surface in messages, at the start of a sentence.</summary>
        public static string Name(SurfaceMesh surface) => string.IsNullOrEmpty(surface.name) ? "The mesh" : $"Mesh '{surface.name}'";

        private static void CheckLength(string name, string what, int length, int vertices)
        {
            if (length != 0 && length != vertices)
                throw new ArgumentException($"{name} has {length} {what} for {vertices} vertices.");
        }
    }
}
