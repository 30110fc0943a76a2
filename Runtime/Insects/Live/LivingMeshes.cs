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
        private static readonly Dictionary<Mesh, (Mesh source, MeshFilter filter)> s_Living = new Dictionary<Mesh, (Mesh, MeshFilter)>();

        /// <summary>Number of living meshes.</summary>
        public static int Count => s_Living.Count;

        /// <summary>Adds a living mesh with its source and its filter.</summary>
        public static void Add(Mesh living, Mesh source, MeshFilter filter) => s_Living.Add(living, (source, filter));

        /// <summary>Removes a living mesh.</summary>
        public static void Remove(Mesh living) => s_Living.Remove(living);

        /// <summary>Authored mesh: the source of a living mesh, or the mesh itself.</summary>
        public static Mesh SourceOf(Mesh mesh) =>
            mesh is null || !s_Living.TryGetValue(mesh, out (Mesh source, MeshFilter filter) entry) ? mesh : entry.source;

        /// <summary>
        /// Returns true where an insect has given this very filter the mesh that it shows; false for the filters of its clones.
        /// </summary>
        public static bool LivesOn(MeshFilter filter)
        {
            Mesh shown = filter.sharedMesh;
            return !(shown is null) && s_Living.TryGetValue(shown, out (Mesh source, MeshFilter filter) entry)
                && ReferenceEquals(entry.filter, filter);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Living.Clear();
    }
}
