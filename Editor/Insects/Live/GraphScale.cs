using System;

namespace Alate.Editor
{
    /// <summary>Range of values that a graph shows: widens at once, narrows slowly to stay calm; always contains zero.</summary>
    internal struct GraphScale
    {
        /// <summary>Share of the way that a bound moves back towards the values in one update.</summary>
        private const float k_Narrowing = 0.02f;

        private bool m_Started;

        /// <summary>Value at the bottom.</summary>
        public float Low { get; private set; }

        /// <summary>Value at the top.</summary>
        public float High { get; private set; }

        /// <summary>Updates the range by the values that are shown now.</summary>
        /// <param name="low">The least.</param>
        /// <param name="high">The largest.</param>
        /// <param name="least">The range is never smaller, above 0.</param>
        public void Fit(float low, float high, float least)
        {
            low = Math.Min(low, 0f);
            high = Math.Max(high, 0f);
            float lacking = 0.5f * Math.Max(least - (high - low), 0f);
            low -= lacking;
            high += lacking;
            Low = !m_Started || low < Low ? low : Low + k_Narrowing * (low - Low);
            High = !m_Started || high > High ? high : High + k_Narrowing * (high - High);
            m_Started = true;
        }

        /// <summary>Height at which a value is drawn: 0 at the bottom, 1 at the top.</summary>
        public float Place(float value) => High > Low ? (value - Low) / (High - Low) : 0.5f;
    }
}
