using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Bakes insects: flies their real wings in a world of their own until each beat is like the one before, then records one.
    /// </summary>
    public static class InsectBaker
    {
        /// <summary>Most vertices of an insect: indices of crowds have 16 bits.</summary>
        public const int MaxVertices = 65535;

        /// <summary>Bakes one clip for each motion.</summary>
        /// <param name="insect">An insect whose wings could live; it need not play, and is not changed.</param>
        /// <param name="motions">What to fly, one clip each, in order.</param>
        /// <param name="settings">How finely.</param>
        /// <param name="proceeds">
        /// Asked once a beat, with the clip's name and the share of the work that is done, 0 to 1: false stops the bake. Null never stops.
        /// </param>
        /// <exception cref="OperationCanceledException">The bake was stopped.</exception>
        /// <exception cref="ArgumentNullException">There is no insect, or there are no motions.</exception>
        /// <exception cref="BakeException">
        /// The insect has a problem or more than <see cref="MaxVertices"/> vertices, two clips have one name, a motion is out of range, a
        /// clip does not loop, or trims for a motion that is flown are missing; the message is one line.
        /// </exception>
        public static InsectBake Bake(
            InsectWings insect, IReadOnlyList<BakeMotion> motions, in BakeSettings settings, Func<string, float, bool> proceeds = null)
        {
            if (insect == null)
                throw new ArgumentNullException(nameof(insect));
            if (motions == null)
                throw new ArgumentNullException(nameof(motions));
            Check(motions);
            BakeSettings chosen = settings.Frames == 0 ? BakeSettings.Default : settings;
            using var drawn = new DrawnInsect(insect);
            BakedSurface surface = drawn.Surface();
            if (surface.VertexCount > MaxVertices)
            {
                throw new BakeException(
                    $"'{insect.name}' has {surface.VertexCount} vertices; at most {MaxVertices} can be baked: use smaller meshes.");
            }
            var wings = new List<BakedWing>();
            int joints = 0;
            foreach (DrawnWing wing in drawn.Wings)
            {
                wings.Add(Describe(wing, drawn.VerticesOf(wing), joints));
                joints += wing.Rig.JointCount;
            }

            var clips = new List<BakedClip>();
            float metresPerUnit = MetresPerUnit(insect, drawn.Wings[0]);
            using var flown = FlownInsect.Of(insect, drawn.Wings);
            foreach (BakeMotion motion in motions)
            {
                using var flight = new BakeFlight(insect, drawn, wings, surface, motion, flown?.Fly(motion), metresPerUnit);
                int before = clips.Count;
                clips.Add(flight.Record(chosen, share => Check(proceeds, motion.Name, (before + share) / motions.Count)));
            }

            return new InsectBake
            {
                Name = insect.name,
                Surface = surface,
                Wings = wings,
                Clips = clips,
                MetresPerUnit = metresPerUnit,
                WingLength = LongestOf(wings),
                Abdomens = drawn.Abdomens.Select((abdomen, k) => abdomen.Describe(joints + k)).ToArray(),
                JointCount = joints + drawn.Abdomens.Count,
            };
        }

        private static void Check(Func<string, float, bool> proceeds, string clip, float share)
        {
            if (proceeds != null && !proceeds(clip, share))
                throw new OperationCanceledException($"The bake was stopped at clip '{clip}'.");
        }

        private static void Check(IReadOnlyList<BakeMotion> motions)
        {
            if (motions.Count == 0)
                throw new BakeException($"No clip is asked for. Known: {string.Join(", ", BakeMotion.Names)}.");
            var names = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            foreach (BakeMotion motion in motions)
            {
                string problem = motion.FindProblem();
                if (problem != null)
                    throw new BakeException(problem);
                if (!names.Add(motion.Name))
                    throw new BakeException($"Clip '{motion.Name}' is asked for twice.");
            }
        }

        private static float MetresPerUnit(InsectWings insect, DrawnWing wing)
        {
            float told = insect.MotionSettings.metresPerUnit;
            WingPreset preset = wing.Wing.Preset == null ? insect.Preset : wing.Wing.Preset;
            return told > 0f ? told : new PresetValues(preset).size.wingLength / wing.Placed.length;
        }

        private static BakedWing Describe(DrawnWing wing, int[] vertices, int firstJoint)
        {
            var rest = new float3[wing.Rig.JointCount];
            for (int joint = 0; joint < rest.Length; joint++)
                rest[joint] = wing.PointOf(wing.Rig.RestJoints[joint]);
            return new BakedWing
            {
                Name = wing.Renderer.name,
                Side = wing.Wing.Side,
                Length = wing.Placed.length,
                Vertices = vertices,
                FirstJoint = firstJoint,
                JointsPerChain = wing.Rig.JointsPerChain,
                RestJoints = rest,
                VertexJoints = wing.Rig.VertexJoints.ToArray(),
                VertexWeights = wing.Rig.VertexWeights.ToArray(),
            };
        }

        private static float LongestOf(List<BakedWing> wings)
        {
            float longest = 0f;
            foreach (BakedWing wing in wings)
                longest = math.max(longest, wing.Length);
            return longest;
        }
    }
}
