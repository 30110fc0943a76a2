namespace Alate
{
    /// <summary>What is read of an asset, kept while somebody looks at it.</summary>
    internal abstract class WatchedValue
    {
        /// <summary>Frames without a look after which a value is let go: in slow motion steps are many frames apart, and insects may be disabled for a moment.</summary>
        private const int k_Patience = 600;

        private int m_FramesUnused;

        /// <summary>Whether it was let go: then it is not read again, and has to be asked for again.</summary>
        public bool IsForgotten => m_FramesUnused > k_Patience;

        /// <summary>Reads the asset again. One that was destroyed keeps its last value.</summary>
        public abstract void Refresh();

        /// <returns>Whether somebody has looked lately.</returns>
        public bool EndRound()
        {
            m_FramesUnused++;
            return !IsForgotten;
        }

        /// <summary>Notes that the value is in use.</summary>
        protected void Use()
        {
            if (!IsForgotten)
                m_FramesUnused = 0;
        }
    }
}
