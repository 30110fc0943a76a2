using System;
using Alate.Fitting;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>Settings for tracing a wing from a picture; start from <see cref="Default"/>.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public struct WingTracingSettings
    {
        /// <summary>Fewest triangles.</summary>
        public const int MinTriangles = 50;

        /// <summary>Most triangles.</summary>
        public const int MaxTriangles = 200000;

        /// <summary>Chains of the skeleton, <see cref="WingSkeleton.MinChains"/> to <see cref="WingSkeleton.MaxChains"/>.</summary>
        public int chains;

        /// <summary>Joints of each chain, <see cref="WingSkeleton.MinJoints"/> to <see cref="WingSkeleton.MaxJoints"/>.</summary>
        public int jointsPerChain;

        /// <summary>Triangles of the mesh, exactly, <see cref="MinTriangles"/> to <see cref="MaxTriangles"/>.</summary>
        public int triangles;

        /// <summary>Distance from the hinge to the tip along the span in the mesh, above 0; in metres or any other unit.</summary>
        public float length;

        /// <summary>Hinge of the wing in the picture, pixels from the top left corner, y down; null to find it.</summary>
        public Vector2? hinge;

        /// <summary>
        /// Direction in the picture towards the leading edge, y down, any length; (0, −1) is up. Null for up, and where the wing points up
        /// or down to guess it from the shape.
        /// </summary>
        public Vector2? forward;

        /// <summary>
        /// True where the skeleton takes the widths of the veins that its chains follow (<see cref="JointChain.veinWidths"/>, wing
        /// lengths), so that thick veins are stiff; default false. For photos and drawings that show widths, all veins in one shade.
        /// </summary>
        public bool veinWidths;

        /// <summary>
        /// Default settings: five chains of five joints in a mesh of a thousand triangles, one unit long; hinge and leading edge are found.
        /// </summary>
        public static WingTracingSettings Default =>
            new WingTracingSettings { chains = 5, jointsPerChain = 5, triangles = 1000, length = 1f };

        /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
        /// <exception cref="ArgumentException">The hinge lies outside the picture, or the forward direction is zero or not
        /// finite.</exception>
        internal void Check(WingPicture picture)
        {
            SkeletonFitSettings.CheckCount(
                chains, WingSkeleton.MinChains, WingSkeleton.MaxChains, nameof(chains), "A skeleton has {0} to {1} chains.");
            SkeletonFitSettings.CheckCount(
                jointsPerChain, WingSkeleton.MinJoints, WingSkeleton.MaxJoints, nameof(jointsPerChain), "A chain has {0} to {1} joints.");
            SkeletonFitSettings.CheckCount(
                triangles, MinTriangles, MaxTriangles, nameof(triangles), "A wing is meshed with {0} to {1} triangles.");
            if (!(length > 0f && length <= 1e6f))
                throw new ArgumentOutOfRangeException(nameof(length), length, "The wing's length is above 0 and at most a million.");
            if (hinge is Vector2 at && !(at.x >= 0f && at.y >= 0f && at.x <= picture.Width && at.y <= picture.Height))
            {
                throw new ArgumentException(
                    FormattableString.Invariant(
                        $"The hinge ({at.x}, {at.y}) lies outside the picture, which is {picture.Width} × {picture.Height} pixels."));
            }

            if (forward is Vector2 to && !(to.sqrMagnitude > 0f && to.sqrMagnitude < float.PositiveInfinity))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"The direction of the leading edge is zero or not finite: ({to.x}, {to.y})."));
            }
        }
    }
}
