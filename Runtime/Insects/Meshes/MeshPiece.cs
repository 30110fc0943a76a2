using UnityEngine;

namespace Alate
{
    /// <summary>Connected triangles of a mesh, and their size.</summary>
    internal sealed class MeshPiece
    {
        /// <summary>The triangles.</summary>
        public readonly MeshSelection selection;

        /// <summary>Bounds of the triangles, mesh space.</summary>
        public readonly Bounds bounds;

        /// <summary>Sum of the triangles' areas, mesh units squared.</summary>
        public readonly float area;

        /// <summary>Middle of the area, mesh space.</summary>
        public readonly Vector3 centroid;

        /// <summary>Middle of the largest triangle, mesh space: a point that identifies this piece.</summary>
        public readonly Vector3 point;

        public MeshPiece(MeshSelection selection, Vector3[] positions)
        {
            this.selection = selection;
            bounds = new Bounds(positions[selection.vertices[0]], Vector3.zero);
            foreach (var vertex in selection.vertices)
                bounds.Encapsulate(positions[vertex]);

            var sum = Vector3.zero;
            var largest = -1f;
            for (var corner = 0; corner < selection.triangles.Length; corner += 3)
            {
                var a = positions[selection.vertices[selection.triangles[corner]]];
                var b = positions[selection.vertices[selection.triangles[corner + 1]]];
                var c = positions[selection.vertices[selection.triangles[corner + 2]]];
                var middle = (a + b + c) / 3f;
                var size = 0.5f * Vector3.Cross(b - a, c - a).magnitude;
                area += size;
                sum += size * middle;
                if (size > largest)
                {
                    largest = size;
                    point = middle;
                }
            }

            centroid = area > 0f ? sum / area : bounds.center;
        }
    }
}
