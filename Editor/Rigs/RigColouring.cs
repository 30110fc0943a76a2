using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Colours of an inspected wing: one for each corner of each of its triangles, so that patches have sharp borders.</summary>
    internal static class RigColouring
    {
        private const byte k_Alpha = 200;

        // Ever lighter from dark blue to pale yellow, so that it reads without seeing hues too.
        private static readonly Color[] s_Ramp =
        {
            new Color(0.10f, 0.09f, 0.32f), new Color(0.34f, 0.22f, 0.62f), new Color(0.73f, 0.29f, 0.51f),
            new Color(0.96f, 0.56f, 0.29f), new Color(1.00f, 0.93f, 0.62f),
        };

        /// <summary>[3 · triangle + corner] Colours of all corners.</summary>
        /// <param name="rig">The wing.</param>
        /// <param name="mode">What to show.</param>
        /// <param name="joints">The selected joints, for <see cref="RigColourMode.JointWeight"/>.</param>
        /// <param name="parameters">The beat, for <see cref="RigColourMode.Delay"/>.</param>
        public static Color32[] Corners(
            RigInspection rig, RigColourMode mode, IReadOnlyCollection<JointIndex> joints, in WingParameters parameters)
        {
            var colours = new Color32[3 * rig.triangles.Count];
            if (mode == RigColourMode.Patch)
            {
                for (int corner = 0; corner < colours.Length; corner++)
                    colours[corner] = OfPatch(rig.patches[corner / 3]);
                return colours;
            }

            float[] shares = Shares(rig, mode, joints, parameters);
            for (int corner = 0; corner < colours.Length; corner++)
                colours[corner] = Ramp(shares[rig.triangles.corners[corner / 3][corner % 3]]);
            return colours;
        }

        /// <summary>Meaning of the two ends of the colours; null where the colours only tell places apart.</summary>
        public static (string low, string high)? Legend(RigInspection rig, RigColourMode mode, in WingParameters parameters)
        {
            switch (mode)
            {
                case RigColourMode.JointWeight:
                    return ("0", "1");
                case RigColourMode.JointMass:
                    return ("0", FormattableString.Invariant($"{100f * Largest(rig.masses):0.#} % of the mass"));
                case RigColourMode.Delay:
                    return ("0°", FormattableString.Invariant($"{math.degrees(Largest(rig.Delays(parameters))):0}° of the beat"));
                default:
                    return null;
            }
        }

        /// <summary>The colour of a share from 0 to 1.</summary>
        public static Color32 Ramp(float share)
        {
            float place = math.saturate(share) * (s_Ramp.Length - 1);
            int step = math.min((int)place, s_Ramp.Length - 2);
            return Translucent(Color.Lerp(s_Ramp[step], s_Ramp[step + 1], place - step));
        }

        // Hues a golden section apart: patches that follow one another never look alike.
        private static Color32 OfPatch(int patch) =>
            Translucent(Color.HSVToRGB(math.frac(patch * 0.618034f), 0.55f, 0.65f + 0.15f * (patch % 3)));

        private static Color32 Translucent(Color colour)
        {
            Color32 bytes = colour;
            bytes.a = k_Alpha;
            return bytes;
        }

        private static float[] Shares(
            RigInspection rig, RigColourMode mode, IReadOnlyCollection<JointIndex> joints, in WingParameters parameters)
        {
            float[] shares = new float[rig.located.Length];
            float[] perJoint = mode == RigColourMode.Delay ? rig.Delays(parameters) : rig.masses;
            float largest = math.max(Largest(perJoint), float.Epsilon);
            for (int vertex = 0; vertex < shares.Length; vertex++)
                shares[vertex] = mode == RigColourMode.JointWeight ? rig.Weight(vertex, joints) : rig.Blend(vertex, perJoint) / largest;
            return shares;
        }

        private static float Largest(float[] values)
        {
            float largest = 0f;
            foreach (float value in values)
                largest = math.max(largest, value);
            return largest;
        }
    }
}
