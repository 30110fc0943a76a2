using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Rims of a mesh: closed ways along edges that belong to one triangle only.</summary>
    internal static class MeshRim
    {
        /// <summary>Finds the rims, each in the sense of the triangles that lie beside it.</summary>
        /// <param name="triangles">Three vertex indices a triangle; vertices in one place are one vertex.</param>
        /// <returns>[rim][place] Vertices; where rims touch in a vertex, one of the ways through it.</returns>
        public static List<int[]> Of(int[] triangles)
        {
            var edges = new MeshEdges(triangles);
            var next = new Dictionary<int, int>();
            for (int k = 0; k < triangles.Length; k++)
            {
                int to = triangles[k % 3 < 2 ? k + 1 : k - 2];
                if (edges.Uses(triangles[k], to) == 1)
                    next[triangles[k]] = to;
            }

            var rims = new List<int[]>();
            var rim = new List<int>();
            foreach (int start in new List<int>(next.Keys))
            {
                rim.Clear();
                for (int at = start; next.Remove(at, out int to); at = to)
                    rim.Add(at);
                if (rim.Count > 2)
                    rims.Add(rim.ToArray());
            }

            return rims;
        }
    }
}
