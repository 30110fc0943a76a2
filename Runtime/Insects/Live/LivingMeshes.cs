using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Meshes that living wings are drawn with, and their authored originals. A clone of a living insect comes with the original's living
    /// mesh; the authored mesh is found here.
    /// </summary>
    internal static class LivingMeshes
    {
        private static readonly Dictionary<MeshFilter, Mesh> s_Shown = new Dictionary<MeshFilter, Mesh>();
        private static readonly Dictionary<Mesh, (Mesh source, int users)> s_Sources = new Dictionary<Mesh, (Mesh, int)>();

        /// <summary>Number of filters that show living meshes.</summary>
        public static int Count => s_Shown.Count;

        /// <summary>Adds a filter with the living mesh that it shows, and the mesh's source.</summary>
        public static void Add(Mesh living, Mesh source, MeshFilter filter)
        {
            // A script may have given the filter another mesh, and somebody else the wing.
            s_Shown[filter] = living;
            s_Sources[living] = (source, s_Sources.TryGetValue(living, out (Mesh source, int users) entry) ? entry.users + 1 : 1);
        }

        /// <summary>Removes a filter and its living mesh.</summary>
        public static void Remove(Mesh living, MeshFilter filter)
        {
            if (s_Shown.TryGetValue(filter, out Mesh shown) && ReferenceEquals(shown, living))
                s_Shown.Remove(filter);
            (Mesh source, int users) = s_Sources[living];
            if (users == 1)
                s_Sources.Remove(living);
            else
                s_Sources[living] = (source, users - 1);
        }

        /// <summary>Authored mesh: the source of a living mesh, or the mesh itself.</summary>
        public static Mesh SourceOf(Mesh mesh) =>
            mesh is null || !s_Sources.TryGetValue(mesh, out (Mesh source, int users) entry) ? mesh : entry.source;

        /// <summary>
        /// Returns true where an insect has given this very filter the mesh that it shows; false for the filters of its clones.
        /// </summary>
        public static bool LivesOn(MeshFilter filter) =>
            s_Shown.TryGetValue(filter, out Mesh living) && ReferenceEquals(filter.sharedMesh, living);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            s_Shown.Clear();
            s_Sources.Clear();
        }
    }
}
