using UnityEngine;

namespace Alate.Samples
{
    /// <summary>The ground below the insects: a plate in patches of green.</summary>
    internal static class MeadowGround
    {
        private const int k_Cells = 60;

        private static readonly Color s_Grass = new Color(0.3f, 0.44f, 0.18f), s_Dry = new Color(0.5f, 0.54f, 0.28f);

        /// <summary>A plate that looks up.</summary>
        /// <param name="radius">Half its width, world units.</param>
        public static Mesh Create(float radius)
        {
            const int row = k_Cells + 1;
            var random = new System.Random(1);
            var positions = new Vector3[row * row];
            var normals = new Vector3[row * row];
            var colours = new Color32[row * row];
            for (int k = 0; k < positions.Length; k++)
            {
                positions[k] = radius * (new Vector3(k % row, 0f, k / row) * (2f / k_Cells) - new Vector3(1f, 0f, 1f));
                normals[k] = Vector3.up;
                colours[k] = Color.Lerp(s_Grass, s_Dry, (float)random.NextDouble());
            }

            int[] triangles = new int[6 * k_Cells * k_Cells];
            for (int k = 0; k < k_Cells * k_Cells; k++)
            {
                int corner = k / k_Cells * row + k % k_Cells, at = 6 * k;
                (triangles[at], triangles[at + 1], triangles[at + 2]) = (corner, corner + row, corner + row + 1);
                (triangles[at + 3], triangles[at + 4], triangles[at + 5]) = (corner, corner + row + 1, corner + 1);
            }

            return new SurfaceMesh { positions = positions, normals = normals, colours = colours, triangles = triangles }.ToMesh("Ground");
        }
    }
}
