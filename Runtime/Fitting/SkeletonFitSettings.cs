using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Fitting
{
    /// <summary>
    /// Settings for fitting a skeleton to a mesh; start from <see cref="Default"/>. All positions and directions are in mesh space.
    /// </summary>
    /// <remarks>
    /// What is not said is guessed, with less confidence and a warning. Of the three places, the hinge counts before the body's point,
    /// and that before the body's side.
    /// </remarks>
    [MovedFrom(true, "Alate", "Alate")]
    public struct SkeletonFitSettings
    {
        /// <summary>Chains, <see cref="WingSkeleton.MinChains"/> to <see cref="WingSkeleton.MaxChains"/>.</summary>
        public int chains;

        /// <summary>Joints of each chain, <see cref="WingSkeleton.MinJoints"/> to <see cref="WingSkeleton.MaxJoints"/>.</summary>
        public int jointsPerChain;

        /// <summary>Point about which the wing turns, on its base; null when unknown.</summary>
        public Vector3? hinge;

        /// <summary>Point of the body, mesh space: the wing's base lies where the wing comes closest to it. Null when unknown.</summary>
        public Vector3? bodyPoint;

        /// <summary>Direction from the wing to the body, any length: the wing's base lies farthest that way. Null when unknown.</summary>
        public Vector3? bodySide;

        /// <summary>
        /// Direction that the insect faces, any length: the leading edge lies on that side. Null to guess it from the shape.
        /// </summary>
        public Vector3? forward;

        /// <summary>
        /// Direction towards the wing's upper side, any length. Null takes the side towards +Y, and where the wing stands upright the front
        /// of its triangles.
        /// </summary>
        public Vector3? up;

        /// <summary>True where the surface's origin is not that of its mesh, and so tells nothing about the body.</summary>
        internal bool isOriginUnknown;

        /// <summary>
        /// Five chains of five joints on a wing that leads with its edge towards +Z, as insects face; its base is guessed.
        /// </summary>
        public static SkeletonFitSettings Default => new SkeletonFitSettings
        {
            chains = 5,
            jointsPerChain = 5,
            forward = new Vector3(0f, 0f, 1f),
        };

        /// <exception cref="ArgumentOutOfRangeException">A count is out of its range.</exception>
        /// <exception cref="ArgumentException">A place is not finite, or a direction is zero or not finite.</exception>
        internal void Check()
        {
            CheckCount(chains, WingSkeleton.MinChains, WingSkeleton.MaxChains, nameof(chains), "A skeleton has {0} to {1} chains.");
            CheckCount(jointsPerChain, WingSkeleton.MinJoints, WingSkeleton.MaxJoints, nameof(jointsPerChain),
                "A skeleton has {0} to {1} joints in a chain.");
            CheckVector(hinge, "hinge", false);
            CheckVector(bodyPoint, "body's point", false);
            CheckVector(bodySide, "body's side", true);
            CheckVector(forward, "forward direction", true);
            CheckVector(up, "up direction", true);
        }

        internal static void CheckCount(int count, int least, int most, string name, string message)
        {
            if (count < least || count > most)
                throw new ArgumentOutOfRangeException(name, count, string.Format(message, least, most));
        }

        private static void CheckVector(Vector3? given, string what, bool isDirection)
        {
            if (!(given is Vector3 v))
                return;
            if (!math.all(math.isfinite((float3)v)))
                throw new ArgumentException($"The {what} to fit a skeleton by is not finite: {Text(v)}.");
            if (isDirection && math.cmax(math.abs((float3)v)) == 0f)
                throw new ArgumentException($"The {what} to fit a skeleton by is zero; it must point somewhere.");
        }

        private static string Text(Vector3 v) => FormattableString.Invariant($"({v.x}, {v.y}, {v.z})");
    }
}
