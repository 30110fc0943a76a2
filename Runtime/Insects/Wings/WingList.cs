using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Compares and merges entries of an insect's list of wings.</summary>
    internal static class WingList
    {
        /// <summary>Returns true where two entries mean equal triangles of one renderer.</summary>
        public static bool SamePart(Wing a, Wing b)
        {
            if (a == null || b == null || a.Renderer != b.Renderer || a.Part != b.Part)
                return false;
            return a.Part == WingPart.WholeMesh
                || (a.Part == WingPart.Submesh && a.Submesh == b.Submesh)
                || (a.Part == WingPart.ConnectedPart && a.Point == b.Point);
        }

        /// <summary>Returns true where another entry of the list means the part of this one, so that one of the two is too many.</summary>
        public static bool HasTwin(IReadOnlyList<Wing> wings, int index)
        {
            for (int w = 0; w < wings.Count; w++)
            {
                if (w != index && index >= 0 && index < wings.Count && SamePart(wings[w], wings[index]))
                    return true;
            }

            return false;
        }

        /// <summary>
        /// Merges the found wings with the settings that they had in the list before; behind them come the wings that the user had added
        /// from renderers in which none were found.
        /// </summary>
        public static List<Wing> Merge(IReadOnlyList<Wing> old, IReadOnlyList<Wing> found)
        {
            var merged = new List<Wing>();
            var renderers = new HashSet<MeshRenderer>();
            foreach (Wing wing in found)
            {
                renderers.Add(wing.Renderer);
                merged.Add(FirstSame(old, wing) ?? wing);
            }

            foreach (Wing wing in old)
            {
                if (wing != null && wing.Renderer != null && !renderers.Contains(wing.Renderer))
                    merged.Add(wing);
            }

            return merged;
        }

        private static Wing FirstSame(IReadOnlyList<Wing> wings, Wing wanted)
        {
            foreach (Wing wing in wings)
            {
                if (SamePart(wing, wanted))
                    return wing;
            }

            return null;
        }
    }
}
