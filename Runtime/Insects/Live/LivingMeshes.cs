using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// The meshes that living wings are drawn with, and those they stand for. A clone of a living insect comes with the original's living mesh and must find its way
    /// back to the mesh that was authored.
    /// </summary>
    internal static class LivingMeshes
    {
        private static readonly Dictionary<Mesh, Entry> s_Living = new Dictionary<Mesh, Entry>();

        /// <summary>Living meshes now.</summary>
        public static int Count => s_Living.Count;

        /// <summary>Notes that a living mesh stands for a source, and where.</summary>
        public static void Add(Mesh living, Mesh source, MeshFilter filter) =>
            s_Living.Add(living, new Entry { source = source, filter = filter });

        /// <summary>Forgets a living mesh.</summary>
        public static void Remove(Mesh living) => s_Living.Remove(living);

        /// <summary>The authored mesh: that for which a living one stands, or the mesh itself.</summary>
        public static Mesh SourceOf(Mesh mesh) => mesh is null || !s_Living.TryGetValue(mesh, out Entry entry) ? mesh : entry.source;

        /// <summary>Whether an insect has given this very filter the mesh that it shows; false for the filters of its clones.</summary>
        public static bool LivesOn(MeshFilter filter)
        {
            Mesh shown = filter.sharedMesh;
            return !(shown is null) && s_Living.TryGetValue(shown, out Entry entry) && ReferenceEquals(entry.filter, filter);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Living.Clear();

        private struct Entry
        {
            public Mesh source;
            public MeshFilter filter;
        }
    }
}
