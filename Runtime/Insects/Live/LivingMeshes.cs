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
        private static readonly Dictionary<Mesh, Mesh> s_Sources = new Dictionary<Mesh, Mesh>();

        /// <summary>Living meshes now.</summary>
        public static int Count => s_Sources.Count;

        /// <summary>Notes that a living mesh stands for a source.</summary>
        public static void Add(Mesh living, Mesh source) => s_Sources.Add(living, source);

        /// <summary>Forgets a living mesh.</summary>
        public static void Remove(Mesh living) => s_Sources.Remove(living);

        /// <summary>The authored mesh: that for which a living one stands, or the mesh itself.</summary>
        public static Mesh SourceOf(Mesh mesh) =>
            mesh is null || !s_Sources.TryGetValue(mesh, out Mesh source) ? mesh : source;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Sources.Clear();
    }
}
