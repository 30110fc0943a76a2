using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>An insect's list of wings: which entries mean the same part of the same mesh.</summary>
    internal static class WingList
    {
        /// <summary>Whether two entries mean the same triangles of the same renderer.</summary>
        public static bool SamePart(Wing a, Wing b)
        {
            if (a == null || b == null || a.Renderer != b.Renderer || a.Part != b.Part)
                return false;
            return a.Part == WingPart.WholeMesh
                || (a.Part == WingPart.Submesh && a.Submesh == b.Submesh)
                || (a.Part == WingPart.ConnectedPart && a.Point == b.Point);
        }

        /// <summary>Whether another entry of the list means the same part as one, so that one of the two is too many.</summary>
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
        /// The wings that were found, with the settings of those that were in the list before; behind them what the user had added from renderers in which none were found.
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
