using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Shares of the screen's height, 0 to 1, below which an insect is computed with less detail; 0 switches a level off.
    /// </summary>
    [Serializable]
    public struct ScreenHeights
    {
        /// <summary>A level is left only when the size has grown by this share beyond its threshold, so that it does not flicker.</summary>
        private const float k_Hysteresis = 0.15f;

        /// <summary>Height below which the detail is <see cref="WingDetail.FewerSubsteps"/>, share of the screen; default 0.2.</summary>
        [Range(0f, 1f)]
        [Tooltip("Share of the screen's height, 0 to 1, below which the insect is computed with half the substeps, but not fewer than 12 a "
            + "beat; with all where it flies. 0 never is. Multiplied by the quality settings' LOD bias.")]
        public float fewerSubstepsBelow;

        /// <summary>
        /// Height below which the detail is <see cref="WingDetail.CoarsePatches"/>, share of the screen; default 0.1. Meshes that the
        /// processor deforms then are drawn with a sixth of their triangles, 64 at least.
        /// </summary>
        [Range(0f, 1f)]
        [Tooltip("Share of the screen's height, 0 to 1, below which the insect is computed with fewer substeps and coarse patches, and a "
            + "mesh that the processor deforms is drawn with a sixth of its triangles. 0 never is. Multiplied by the quality settings' "
            + "LOD bias.")]
        public float coarsePatchesBelow;

        /// <summary>Height below which the detail is <see cref="WingDetail.WavesOnly"/>, share of the screen; default 0.03.</summary>
        [Range(0f, 1f)]
        [Tooltip("Share of the screen's height, 0 to 1, below which the insect is computed with the driven waves alone. 0 never is. "
            + "Multiplied by the quality settings' LOD bias.")]
        public float wavesOnlyBelow;

        /// <summary>Height below which the detail is <see cref="WingDetail.Frozen"/>, share of the screen; default 0.005.</summary>
        [Range(0f, 1f)]
        [Tooltip("Share of the screen's height, 0 to 1, below which the wings come to rest. 0 never do. Multiplied by the quality "
            + "settings' LOD bias.")]
        public float restBelow;

        /// <summary>The threshold of a level.</summary>
        internal float Of(WingDetail detail)
        {
            switch (detail)
            {
                case WingDetail.FewerSubsteps: return fewerSubstepsBelow;
                case WingDetail.CoarsePatches: return coarsePatchesBelow;
                case WingDetail.WavesOnly: return wavesOnlyBelow;
                case WingDetail.Frozen: return restBelow;
                default: return 1f;
            }
        }

        /// <summary>The level of detail for a share of the screen's height.</summary>
        internal WingDetail Choose(float screenHeight, WingDetail current)
        {
            for (WingDetail level = WingDetail.Frozen; level > WingDetail.Full; level--)
            {
                if (screenHeight < Of(level) * (level <= current ? 1f + k_Hysteresis : 1f))
                    return level;
            }

            return WingDetail.Full;
        }

        internal ScreenHeights Clamped() => new ScreenHeights
        {
            fewerSubstepsBelow = math.saturate(fewerSubstepsBelow),
            coarsePatchesBelow = math.saturate(coarsePatchesBelow),
            wavesOnlyBelow = math.saturate(wavesOnlyBelow),
            restBelow = math.saturate(restBelow),
        };
    }
}
