using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Finds the renderers with meshes that draw an insect from near.</summary>
    internal static class DrawnRenderers
    {
        /// <summary>Finds all renderers below an object that draw a mesh, except those of the lower levels of detail.</summary>
        /// <param name="root">The insect.</param>
        /// <param name="hiddenToo">Also those that are disabled or inactive below the root; the root itself may be inactive.</param>
        public static List<Renderer> Under(Transform root, bool hiddenToo)
        {
            HashSet<Renderer> lower = LowerLevels(root);
            var drawn = new List<Renderer>();
            foreach (Renderer renderer in root.GetComponentsInChildren<Renderer>(true))
            {
                if (MeshOf(renderer) != null && !lower.Contains(renderer) && (hiddenToo || IsShown(renderer, root)))
                    drawn.Add(renderer);
            }

            return drawn;
        }

        /// <summary>Mesh that a renderer draws; null if it draws none, or something else.</summary>
        public static Mesh MeshOf(Renderer renderer)
        {
            switch (renderer)
            {
                case SkinnedMeshRenderer skinned:
                    return skinned.sharedMesh;
                case MeshRenderer plain when plain.TryGetComponent(out MeshFilter filter):
                    return filter.sharedMesh;
                default:
                    return null;
            }
        }

        private static HashSet<Renderer> LowerLevels(Transform root)
        {
            var lower = new HashSet<Renderer>();
            var best = new HashSet<Renderer>();
            foreach (LODGroup group in root.GetComponentsInChildren<LODGroup>(true))
            {
                LOD[] levels = group.GetLODs();
                for (int level = 0; level < levels.Length; level++)
                    (level == 0 ? best : lower).UnionWith(levels[level].renderers ?? System.Array.Empty<Renderer>());
            }

            lower.ExceptWith(best);
            return lower;
        }

        private static bool IsShown(Renderer renderer, Transform root)
        {
            if (!renderer.enabled)
                return false;
            for (Transform place = renderer.transform; place != root; place = place.parent)
            {
                if (!place.gameObject.activeSelf)
                    return false;
            }

            return true;
        }
    }
}
