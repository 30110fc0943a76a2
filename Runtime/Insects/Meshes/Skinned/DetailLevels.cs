using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Adds renderers to the levels of detail of another, and removes them.</summary>
    internal static class DetailLevels
    {
        /// <summary>Groups above a renderer, hidden ones too.</summary>
        public static IReadOnlyList<LODGroup> Above(Renderer renderer) => renderer.GetComponentsInParent<LODGroup>(true);

        /// <summary>Shows renderers in the levels of a group in which another one is shown.</summary>
        public static void Add(LODGroup group, Renderer beside, IReadOnlyList<Renderer> added)
        {
            Change(group, renderers =>
            {
                if (renderers.Contains(beside))
                    renderers.AddRange(added);
            });
        }

        /// <summary>Removes renderers from all levels of a group.</summary>
        public static void Remove(LODGroup group, IReadOnlyList<Renderer> removed)
        {
            Change(group, renderers =>
            {
                foreach (Renderer renderer in removed)
                    renderers.Remove(renderer);
            });
        }

        private static void Change(LODGroup group, Action<List<Renderer>> change)
        {
            LOD[] levels = group.GetLODs();
            for (int level = 0; level < levels.Length; level++)
            {
                var renderers = new List<Renderer>(levels[level].renderers ?? Array.Empty<Renderer>());
                change(renderers);
                levels[level].renderers = renderers.ToArray();
            }

            group.SetLODs(levels);
        }
    }
}
