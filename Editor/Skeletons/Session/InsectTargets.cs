using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Finds the skeletons of insects, for editing in place.</summary>
    internal static class InsectTargets
    {
        /// <summary>Finds the skeletons of all wings of some insects, each once where several wings share one.</summary>
        public static List<SkeletonTarget> Find(IEnumerable<InsectWings> insects)
        {
            var targets = new List<SkeletonTarget>();
            foreach (InsectWings insect in insects)
                Add(insect, targets);
            return targets;
        }

        /// <summary>Hash of the result of <see cref="Find"/>, without the content of skeletons, meshes and presets.</summary>
        public static int StampOf(IEnumerable<InsectWings> insects)
        {
            var stamp = new HashCode();
            foreach (InsectWings insect in insects)
            {
                foreach (Wing wing in insect.Wings)
                {
                    Mesh mesh = wing == null ? null : InsectCheck.MeshOf(wing, InsectCheck.FilterOf(wing));
                    if (mesh == null)
                        continue;
                    stamp.Add(mesh);
                    stamp.Add(wing.Skeleton);
                    stamp.Add(wing.Part);
                    stamp.Add(wing.Submesh);
                    stamp.Add(wing.Point);
                    stamp.Add(wing.Side);
                    stamp.Add(wing.Pair);
                    stamp.Add(wing.Preset != null ? wing.Preset : insect.Preset);
                }
            }

            return stamp.ToHashCode();
        }

        /// <summary>Finds the wings of an insect that have a mesh but no skeleton yet.</summary>
        public static List<Wing> WithoutSkeleton(InsectWings insect)
        {
            var bare = new List<Wing>();
            foreach (Wing wing in insect.Wings)
            {
                if (wing != null && wing.Skeleton == null && SurfaceOf(wing, out _) != null)
                    bare.Add(wing);
            }

            return bare;
        }

        /// <summary>Triangles of a wing, in the space of its mesh; null where the mesh has none that can be read.</summary>
        /// <param name="wing">The wing.</param>
        /// <param name="refusal">Why there are none, one sentence; null where there are.</param>
        public static SurfaceMesh SurfaceOf(Wing wing, out string refusal)
        {
            Mesh mesh = InsectCheck.MeshOf(wing, InsectCheck.FilterOf(wing));
            refusal = mesh == null ? "The wing has no mesh." : null;
            if (refusal != null)
                return null;
            try
            {
                return MeshParts.Surface(mesh, MeshParts.Select(mesh, wing.Part, wing.Submesh, wing.Point));
            }
            catch (ArgumentException refused)
            {
                refusal = refused.Message;
                return null;
            }
        }

        private static void Add(InsectWings insect, List<SkeletonTarget> targets)
        {
            var own = new List<(Wing wing, SkeletonTarget target)>();
            foreach (Wing wing in insect.Wings)
            {
                if (wing == null || wing.Renderer == null || wing.Skeleton == null || targets.Exists(t => t.Skeleton == wing.Skeleton))
                    continue;
                var target = new SkeletonTarget(wing.Skeleton, SurfaceOf(wing, out string without), wing.Renderer.transform)
                {
                    WithoutSurface = without,
                    Insect = insect.transform,
                    Preset = wing.Preset != null ? wing.Preset : insect.Preset,
                };
                targets.Add(target);
                own.Add((wing, target));
            }

            foreach ((Wing wing, SkeletonTarget target) in own)
                target.OtherSide = own.Find(other => other.wing.Side != wing.Side && other.wing.Pair == wing.Pair).target;
        }
    }
}
