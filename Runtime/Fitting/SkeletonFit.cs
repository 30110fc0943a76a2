using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>A skeleton that <see cref="SkeletonFitter"/> laid into a wing, and how sure it is.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class SkeletonFit
    {
        internal SkeletonFit(
            WingSkeleton skeleton, float confidence, IReadOnlyList<SkeletonFitWarning> warnings, Vector3[] outline, IReadOnlyList<Vector3[]> holes)
        {
            Skeleton = skeleton;
            Confidence = confidence;
            Warnings = warnings;
            Outline = outline;
            Holes = holes;
        }

        /// <summary>A valid skeleton in mesh space, new and the caller's own.</summary>
        public WingSkeleton Skeleton { get; }

        /// <summary>
        /// 0 to 1: the product of how sure the hinge, the leading edge, the upper side, the tip and the outline are. 1 when all were said and
        /// the wing is plain; below about 0.5 an artist should look.
        /// </summary>
        public float Confidence { get; }

        /// <summary>What lowers the confidence, by name; empty when nothing does.</summary>
        public IReadOnlyList<SkeletonFitWarning> Warnings { get; }

        /// <summary>The wing's boundary that was found, mesh space: vertices in order around it, the last joined to the first.</summary>
        public Vector3[] Outline { get; }

        /// <summary>The boundaries of its holes, mesh space, likewise.</summary>
        public IReadOnlyList<Vector3[]> Holes { get; }

        /// <summary>Whether there is a warning of this kind.</summary>
        public bool Warns(SkeletonFitWarningKind kind)
        {
            foreach (SkeletonFitWarning warning in Warnings)
            {
                if (warning.Kind == kind)
                    return true;
            }

            return false;
        }
    }
}
