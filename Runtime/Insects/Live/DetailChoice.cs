namespace Alate
{
    /// <summary>Chooses an insect's level of detail by its size on the screen.</summary>
    internal static class DetailChoice
    {
        /// <summary>Growth beyond a threshold, as a share, at which a level is left, so that the level does not flicker.</summary>
        private const float k_Hysteresis = 0.15f;

        /// <summary>Chooses the level for a size.</summary>
        /// <param name="screenHeight">Share of the screen's height.</param>
        /// <param name="thresholds">Below which the levels after the first begin.</param>
        /// <param name="current">The level now.</param>
        public static WingDetail Choose(float screenHeight, in ScreenHeights thresholds, WingDetail current)
        {
            for (int level = (int)WingDetail.Frozen; level > (int)WingDetail.Full; level--)
            {
                float threshold = thresholds.Of((WingDetail)level);
                if (level <= (int)current)
                    threshold *= 1f + k_Hysteresis;
                if (screenHeight < threshold)
                    return (WingDetail)level;
            }

            return WingDetail.Full;
        }
    }
}
