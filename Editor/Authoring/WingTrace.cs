using System.Collections.Generic;
using Alate.Fitting;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>Result of <see cref="WingTracer"/> for a picture: places in it are in pixels from its top left corner, y down.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class WingTrace
    {
        internal WingTrace(
            WingPlacement placement, Vector2[] outline, SurfaceMesh surface, WingSkeleton skeleton, bool[] followsVein,
            IReadOnlyList<Vector2[]> veins, float confidence, IReadOnlyList<string> warnings)
        {
            Placement = placement;
            Outline = outline;
            Surface = surface;
            Skeleton = skeleton;
            FollowsVein = followsVein;
            Veins = veins;
            Confidence = confidence;
            Warnings = warnings;
        }

        /// <summary>Placement of the mesh in the picture.</summary>
        public WingPlacement Placement { get; }

        /// <summary>The wing's outline in the picture, closed.</summary>
        public Vector2[] Outline { get; }

        /// <summary>
        /// The wing's mesh in the plane y = 0, facing up, with the hinge at the origin and the leading edge towards +Z; a right wing runs
        /// along +X, a left one along −X. Its texture coordinates are those of the picture.
        /// </summary>
        public SurfaceMesh Surface { get; }

        /// <summary>A valid skeleton in the mesh's space, new and the caller's own.</summary>
        public WingSkeleton Skeleton { get; }

        /// <summary>[chain] True where the chain follows a vein of the picture; the others are fitted to the outline.</summary>
        public IReadOnlyList<bool> FollowsVein { get; }

        /// <summary>The radial veins that were found in the picture, each from the hinge to the margin.</summary>
        public IReadOnlyList<Vector2[]> Veins { get; }

        /// <summary>Confidence in hinge, leading edge and tip, 0 to 1, as <see cref="SkeletonFit.Confidence"/>.</summary>
        public float Confidence { get; }

        /// <summary>Points that the user should check, a sentence each; empty when there are none.</summary>
        public IReadOnlyList<string> Warnings { get; }
    }
}
