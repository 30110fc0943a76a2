using System;
using Alate.Fitting;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>
    /// Wings as scans have them, far wilder than <see cref="RandomWings"/>, with any hinge, any forward direction and any counts.
    /// </summary>
    internal static class WildWings
    {
        /// <summary>
        /// Some of the seeds whose chains along the wing's edges cross or break another rule; of the first 1500 seeds 42 do.
        /// </summary>
        public static readonly int[] Crossing = [54, 157, 165, 212];

        /// <summary>More of them.</summary>
        public static readonly int[] MoreCrossing =
            [60, 63, 163, 185, 219, 220, 257, 285, 322, 348, 396, 410, 649, 687, 877, 1036, 1164, 1239, 1269, 1395];

        public static SurfaceMesh Make(int seed, out SkeletonFitSettings hints)
        {
            var random = new Random(seed);
            PolarWing wing = RandomWings.Make(seed);
            double wild = 1.0 + 3.0 * random.NextDouble();
            for (int k = 0; k < wing.waves.Length; k++)
                wing.waves[k] *= wild;
            if (random.Next(2) == 0)
            {
                wing.tail = -0.3 - 0.6 * random.NextDouble();
                wing.tailAngle = 6.28 * random.NextDouble();
                wing.tailWidth = 0.05 + 0.2 * random.NextDouble();
            }

            wing.aspect = Math.Max(wing.aspect, 0.2);
            hints = SkeletonFitSettings.Default;
            hints.chains = random.Next(WingSkeleton.MinChains, WingSkeleton.MaxChains + 1);
            hints.jointsPerChain = random.Next(WingSkeleton.MinJoints, WingSkeleton.MaxJoints + 1);
            hints.hinge = wing.At(6.28 * random.NextDouble());
            double ahead = 6.28 * random.NextDouble();
            hints.forward = random.Next(3) == 0 ? null : new Vector3((float)Math.Cos(ahead), 0f, (float)Math.Sin(ahead));
            return wing.Mesh(seed);
        }
    }
}
