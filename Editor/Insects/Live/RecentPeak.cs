namespace Alate.Editor
{
    /// <summary>Largest value of the last beat, so that the shown number does not flicker with every beat.</summary>
    internal struct RecentPeak
    {
        private double m_Beat;

        /// <summary>The largest value; 0 before the first.</summary>
        public float Value { get; private set; }

        /// <summary>Takes the next value; values older than a beat are dropped, and those of a wing that has restarted.</summary>
        /// <param name="beat">Beats completed, with the share of the one under way.</param>
        /// <param name="value">At that time.</param>
        public void Add(double beat, float value)
        {
            if (!(value >= Value) && beat >= m_Beat && beat <= m_Beat + 1.0)
                return;
            Value = value;
            m_Beat = beat;
        }
    }
}
