using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>How finely an insect's wings are computed, near the camera and far from it.</summary>
    [Serializable]
    public struct InsectQuality
    {
        /// <summary>Most patches that can be asked for.</summary>
        public const int MaxPatches = 4096;

        /// <summary>Substeps of a beat, 12 to 480; 0 takes the preset's.</summary>
        [Tooltip("Substeps of one beat, 12 to 480; 0 takes the preset's (24). More is steadier for very soft wings and costs in proportion.")]
        public int substepsPerBeat;

        /// <summary>Surface patches that meet the air, 24 to 4096.</summary>
        [Range(WingRigSettings.CoarsePatches, MaxPatches)]
        [Tooltip("Surface patches that meet the air, 24 to 4096; 256. Fewer cost less; shared by all insects of the same mesh and number.")]
        public int patches;

        /// <summary>Whether far insects are computed with less detail.</summary>
        [Tooltip("Computes insects that look small with less detail. Off: always in full.")]
        public bool levelOfDetail;

        /// <summary>Shares of the screen's height below which each level begins: fewer substeps, coarse patches, waves only, frozen.</summary>
        [Tooltip("Shares of the screen's height that the insect fills, 0 to 1, below which it has fewer substeps (x), coarse patches (y), waves only (z), and its wings come to rest (w). 0 never enters the level.")]
        public Vector4 screenHeights;

        /// <summary>What is saved out of sight.</summary>
        [Tooltip("What is saved while no camera sees the wings. Everything: the beat is made up for on return. Skinning: forces are computed on. Nothing: all goes on.")]
        public WingCulling culling;

        /// <summary>The preset's substeps, 256 patches, detail by screen size, nothing computed out of sight.</summary>
        public static InsectQuality Default => new InsectQuality
        {
            patches = WingRigSettings.Default.patchCount,
            levelOfDetail = true,
            screenHeights = new Vector4(0.2f, 0.1f, 0.03f, 0.005f),
        };

        internal InsectQuality Clamped()
        {
            InsectQuality clamped = this;
            if (substepsPerBeat != 0)
                clamped.substepsPerBeat = math.clamp(substepsPerBeat, WingParameters.MinSubsteps, WingParameters.MaxSubsteps);
            clamped.patches = math.clamp(patches, WingRigSettings.CoarsePatches, MaxPatches);
            for (int level = 0; level < 4; level++)
                clamped.screenHeights[level] = math.saturate(screenHeights[level]);
            return clamped;
        }
    }
}
