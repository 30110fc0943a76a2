namespace Alate
{
    /// <summary>Value read of an asset, kept while it is in use.</summary>
    internal abstract class WatchedValue
    {
        /// <summary>
        /// Number of unused frames after which a value is released: in slow motion steps are many frames apart, and insects may be disabled
        /// for a moment.
        /// </summary>
        private const int k_Patience = 600;

        private int m_FramesUnused;

        /// <summary>True once the value was released: then it is not read again, and must be requested again.</summary>
        public bool IsForgotten => m_FramesUnused > k_Patience;

        /// <summary>Reads the asset again. Keeps the last value where the asset was destroyed.</summary>
        public abstract void Refresh();

        /// <returns>Whether somebody has looked lately.</returns>
        public bool EndRound()
        {
            m_FramesUnused++;
            return !IsForgotten;
        }

        /// <summary>Marks the value as in use.</summary>
        protected void Use()
        {
            if (!IsForgotten)
                m_FramesUnused = 0;
        }
    }
}
