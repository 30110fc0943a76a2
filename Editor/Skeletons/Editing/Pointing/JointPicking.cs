using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Finds joints by their places on the screen.</summary>
    internal static class JointPicking
    {
        /// <summary>Largest distance, pixels, at which joints count as one behind the other; the nearer one is taken.</summary>
        private const float k_SamePlace = 2f;

        /// <summary>Finds the joint seen closest to a pixel; of those seen at one place the nearest to the eye.</summary>
        /// <param name="editing">Whose joints.</param>
        /// <param name="project">The view.</param>
        /// <param name="pixel">Where.</param>
        /// <param name="radius">Farthest distance, pixels.</param>
        /// <param name="found">The joint.</param>
        /// <param name="distance">Its distance from the pixel.</param>
        public static bool TryNearest(
            SkeletonEditing editing, ScreenProjection project, Vector2 pixel, float radius, out JointIndex found, out float distance)
        {
            found = default;
            distance = float.PositiveInfinity;
            float depth = float.PositiveInfinity;
            foreach ((JointIndex joint, Vector3 seen) in Seen(editing, project))
            {
                float away = Vector2.Distance(seen, pixel);
                bool better = away < distance - k_SamePlace || (away < distance + k_SamePlace && seen.z < depth);
                if (!(away <= radius) || !better)
                    continue;
                found = joint;
                distance = away;
                depth = seen.z;
            }

            return distance < float.PositiveInfinity;
        }

        /// <summary>The joint closest to a ray as seen from where it begins, in the world.</summary>
        /// <param name="editing">Whose joints.</param>
        /// <param name="ray">The ray.</param>
        /// <param name="degrees">Farthest angle between the ray and the line of sight to the joint.</param>
        /// <param name="found">The joint.</param>
        public static bool TryNearest(SkeletonEditing editing, Ray ray, float degrees, out JointIndex found)
        {
            found = default;
            float least = degrees;
            bool any = false;
            foreach (JointIndex joint in All(editing.Skeleton))
            {
                Vector3 sight = editing.LocalToWorld.MultiplyPoint3x4(editing.Skeleton.GetJoint(joint.chain, joint.joint)) - ray.origin;
                float angle = Vector3.Angle(ray.direction, sight);
                if (!(angle <= least))
                    continue;
                least = angle;
                found = joint;
                any = true;
            }

            return any;
        }

        /// <summary>The joints seen within a rectangle, chain by chain.</summary>
        public static List<JointIndex> Inside(SkeletonEditing editing, ScreenProjection project, Rect rectangle)
        {
            var inside = new List<JointIndex>();
            foreach ((JointIndex joint, Vector3 seen) in Seen(editing, project))
            {
                if (rectangle.Contains((Vector2)seen))
                    inside.Add(joint);
            }

            return inside;
        }

        /// <summary>All joints of a skeleton, chain by chain from root to tip.</summary>
        public static IEnumerable<JointIndex> All(WingSkeleton skeleton)
        {
            for (int i = 0; i < skeleton.ChainCount; i++)
            {
                for (int j = 0; j < skeleton.Chains[i].Length; j++)
                    yield return new JointIndex(i, j);
            }
        }

        private static IEnumerable<(JointIndex joint, Vector3 seen)> Seen(SkeletonEditing editing, ScreenProjection project)
        {
            foreach (JointIndex joint in All(editing.Skeleton))
            {
                Vector3 seen = project(editing.LocalToWorld.MultiplyPoint3x4(editing.Skeleton.GetJoint(joint.chain, joint.joint)));
                if (seen.z > 0f)
                    yield return (joint, seen);
            }
        }
    }
}
