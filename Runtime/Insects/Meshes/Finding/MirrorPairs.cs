using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Finds sheets that are mirror images of each other in the insect's middle plane, as wings are.</summary>
    internal static class MirrorPairs
    {
        // Differences allowed between the two: of area, and of place and size over the side of a square of that area.
        private const float k_Area = 0.2f;
        private const float k_Place = 0.25f;

        // Area over that of the largest pair from which a pair is wings, not leaves of the antennae or tails.
        private const float k_SmallestPair = 0.2f;

        private const int k_Most = 2;

        /// <summary>Finds the members of the largest pairs, two pairs at most.</summary>
        public static List<WingCandidate> Of(List<WingCandidate> candidates)
        {
            List<WingCandidate> sheets = candidates.FindAll(one => one.shape.isSheet && one.shape.Side != null);
            sheets.Sort((a, b) => b.shape.area.CompareTo(a.shape.area));
            var found = new List<WingCandidate>();
            while (sheets.Count > 1 && found.Count < 2 * k_Most)
            {
                WingCandidate first = sheets[0];
                sheets.RemoveAt(0);
                if (found.Count > 0 && first.shape.area < k_SmallestPair * found[0].shape.area)
                    break;
                WingCandidate other = Nearest(first, sheets);
                if (other == null)
                    continue;
                sheets.Remove(other);
                found.Add(first);
                found.Add(other);
            }

            return found;
        }

        private static WingCandidate Nearest(WingCandidate one, List<WingCandidate> others)
        {
            WingCandidate nearest = null;
            float least = k_Place;
            foreach (WingCandidate other in others)
            {
                if (other.Side == one.Side || other.shape.area < (1f - k_Area) * one.shape.area)
                    continue;
                float distance = Distance(one.shape, other.shape);
                if (distance < least)
                {
                    least = distance;
                    nearest = other;
                }
            }

            return nearest;
        }

        private static float Distance(WingShape one, WingShape other)
        {
            Vector3 apart = Vector3.Scale(one.centroid, new Vector3(-1f, 1f, 1f)) - other.centroid;
            Vector3 larger = one.bounds.size - other.bounds.size;
            return Mathf.Max(apart.magnitude, larger.magnitude) / Mathf.Sqrt(one.area);
        }
    }
}
