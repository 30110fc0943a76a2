using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Fineness of the computation of an insect's wings, near the camera and far from it.</summary>
    [Serializable]
    public struct InsectQuality
    {
        /// <summary>Largest number of patches.</summary>
        public const int MaxPatches = 4096;

        /// <summary>Substeps of a beat, 12 to 480; 0 takes the preset's.</summary>
        [Tooltip("Substeps of one beat, 12 to 480; 0 takes the preset's (16, expressive ones 24 to 36). More is more accurate and "
            + "costs in proportion.")]
        public int substepsPerBeat;

        /// <summary>Surface patches that meet the air, 24 to 4096.</summary>
        [Range(WingRigSettings.CoarsePatches, MaxPatches)]
        [Tooltip("Surface patches that meet the air, 24 to 4096; 64. Fewer cost less; shared by all insects of the same mesh and number.")]
        public int patches;

        /// <summary>True where far insects are computed with less detail.</summary>
        [Tooltip("Computes insects that look small with less detail. Off: always in full.")]
        public bool levelOfDetail;

        /// <summary>Sizes on the screen below which each level begins.</summary>
        public ScreenHeights screenHeights;

        /// <summary>Computation out of sight.</summary>
        [Tooltip("What is computed while no camera sees the wings. Cull Completely: nothing; the beat is made up for on return. Cull "
            + "Skinning: forces and joints. Always Simulate: everything.")]
        public WingCulling culling;

        /// <summary>True where forces are computed however small or hidden the insect is.</summary>
        [Tooltip("Computes the air's forces however small the insect is and though no camera sees it: for a body that the wings carry. "
            + "Costs as much as coarse patches.")]
        public bool keepForces;

        /// <summary>
        /// True where the wings have motion vectors of their own, for temporal antialiasing and motion blur; costs 8 bytes a vertex.
        /// </summary>
        [Tooltip("Gives the wings motion vectors of their own, for temporal antialiasing and motion blur. Costs 8 bytes a vertex; leave it "
            + "off without such effects.")]
        public bool motionVectors;

        /// <summary>Choice of what deforms the meshes: the processor or the graphics card.</summary>
        [Tooltip("What deforms the meshes. Cpu: the processor, on every device and with every shader. Gpu: the graphics card, in the "
            + "shader Alate/Wing; insects of one mesh are then drawn together. Automatic: the graphics card where it can.")]
        public WingSkinning skinning;

        /// <summary>Default settings: the preset's substeps, 64 patches, detail by screen size, nothing computed out of sight.</summary>
        public static InsectQuality Default => new InsectQuality
        {
            patches = WingRigSettings.Default.patchCount,
            levelOfDetail = true,
            screenHeights =
                new ScreenHeights { fewerSubstepsBelow = 0.2f, coarsePatchesBelow = 0.1f, wavesOnlyBelow = 0.03f, restBelow = 0.005f },
        };

        internal InsectQuality Clamped()
        {
            InsectQuality clamped = this;
            if (substepsPerBeat != 0)
                clamped.substepsPerBeat = math.clamp(substepsPerBeat, WingParameters.MinSubsteps, WingParameters.MaxSubsteps);
            clamped.patches = math.clamp(patches, WingRigSettings.CoarsePatches, MaxPatches);
            clamped.screenHeights = screenHeights.Clamped();
            return clamped;
        }
    }
}
