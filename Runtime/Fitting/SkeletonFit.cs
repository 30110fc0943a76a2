using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>Skeleton that <see cref="SkeletonFitter"/> laid into a wing, with its confidence and warnings.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class SkeletonFit
    {
        internal SkeletonFit(
            WingSkeleton skeleton, float confidence, IReadOnlyList<SkeletonFitWarning> warnings, Vector3[] outline,
            IReadOnlyList<Vector3[]> holes)
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
        /// Confidence, 0 to 1: the product of those in hinge, leading edge, upper side, tip and outline. 1 when all were given and the wing
        /// is plain; check the skeleton by eye below about 0.5.
        /// </summary>
        public float Confidence { get; }

        /// <summary>Reasons for a lower confidence, by name; empty when there are none.</summary>
        public IReadOnlyList<SkeletonFitWarning> Warnings { get; }

        /// <summary>Boundary of the wing that was found, mesh space: vertices in order around it, the last joined to the first.</summary>
        public Vector3[] Outline { get; }

        /// <summary>Boundaries of the wing's holes, mesh space: vertices in order, the last joined to the first.</summary>
        public IReadOnlyList<Vector3[]> Holes { get; }

        /// <summary>Returns true where there is a warning of this kind.</summary>
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
