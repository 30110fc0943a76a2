using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Groups the sheets of one side that make up one wing: its membrane, its veins, its other face.</summary>
    internal static class WingGroup
    {
        // A sheet belongs to a larger one if this share of its plan lies over the larger one's box …
        private const float k_Inside = 0.9f;

        // … and their middles are nearer to each other, along the body, than this share of the larger one's length.
        private const float k_Apart = 0.2f;

        /// <summary>Number of wings on the side that has more.</summary>
        public static int Count(List<(WingShape shape, Vector3 point, int submesh)> pieces)
        {
            List<WingShape> right = pieces.FindAll(piece => piece.shape.Side == WingSide.Right).ConvertAll(piece => piece.shape);
            List<WingShape> left = pieces.FindAll(piece => piece.shape.Side == WingSide.Left).ConvertAll(piece => piece.shape);
            return Mathf.Max(Divide(right, out _), Divide(left, out _));
        }

        /// <summary>Numbers the wings that the shapes of one side make up.</summary>
        /// <param name="shapes">Shapes of one side.</param>
        /// <param name="groups">The number of the wing that each shape belongs to, from 0, from front to back.</param>
        /// <returns>The number of wings.</returns>
        public static int Divide(List<WingShape> shapes, out int[] groups)
        {
            var bySize = new List<int>();
            for (int place = 0; place < shapes.Count; place++)
                bySize.Add(place);
            bySize.Sort((a, b) => shapes[b].area.CompareTo(shapes[a].area));

            var largest = new List<int>();
            int[] owners = new int[shapes.Count];
            foreach (int place in bySize)
            {
                int owner = largest.FindIndex(other => Belongs(shapes[place], shapes[other]));
                if (owner < 0)
                    largest.Add(place);
                owners[place] = owner < 0 ? place : largest[owner];
            }

            largest.Sort((a, b) => shapes[b].centroid.z.CompareTo(shapes[a].centroid.z));
            groups = System.Array.ConvertAll(owners, largest.IndexOf);
            return largest.Count;
        }

        private static bool Belongs(WingShape part, WingShape whole)
        {
            float apart = Mathf.Abs(part.centroid.z - whole.centroid.z);
            return apart <= k_Apart * whole.bounds.size.z
                && Inside(part, whole, 0) >= k_Inside && Inside(part, whole, 2) >= k_Inside;
        }

        private static float Inside(WingShape part, WingShape whole, int axis)
        {
            float low = Mathf.Max(part.bounds.min[axis], whole.bounds.min[axis]);
            float common = Mathf.Min(part.bounds.max[axis], whole.bounds.max[axis]) - low;
            if (part.bounds.size[axis] > 0f)
                return common / part.bounds.size[axis];
            return common < 0f ? 0f : 1f;
        }
    }
}
