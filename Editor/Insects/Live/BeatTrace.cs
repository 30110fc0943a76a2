using System;

namespace Alate.Editor
{
    /// <summary>
    /// Last beats of an insect: a ring of samples. Frames are too far apart to show one quick beat, so the samples of several are folded
    /// into one, by phase.
    /// </summary>
    internal sealed class BeatTrace
    {
        private readonly BeatSample[] m_Ring;
        private readonly BeatSample[] m_Folded;
        private readonly float[] m_Phases;
        private readonly double m_Beats;
        private int m_Next;

        /// <param name="capacity">Most samples that are kept, 1 or more.</param>
        /// <param name="beats">Beats back from the last sample that count, above 0.</param>
        public BeatTrace(int capacity, double beats)
        {
            if (capacity < 1)
                throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "A trace keeps one sample or more.");
            if (!(beats > 0.0))
                throw new ArgumentOutOfRangeException(nameof(beats), beats, "A trace shows more than no beat.");
            m_Ring = new BeatSample[capacity];
            m_Folded = new BeatSample[capacity];
            m_Phases = new float[capacity];
            m_Beats = beats;
        }

        /// <summary>Number of samples that are kept.</summary>
        public int Count { get; private set; }

        /// <summary>A sample; 0 is the oldest.</summary>
        public BeatSample this[int index] => index >= 0 && index < Count
            ? m_Ring[(m_Next - Count + index + m_Ring.Length) % m_Ring.Length]
            : throw new ArgumentOutOfRangeException(nameof(index), index, $"The trace has {Count} samples.");

        /// <summary>The newest sample; all zero for none.</summary>
        public BeatSample Last => Count == 0 ? default : this[Count - 1];

        /// <summary>
        /// Adds a sample. A sample that is not later than the last one starts a new trace, unless both are equal; one that is not finite is
        /// ignored.
        /// </summary>
        public void Add(in BeatSample sample)
        {
            if (!IsFinite(sample))
                return;
            if (Count > 0 && sample.beat == Last.beat)
                return;
            if (Count > 0 && sample.beat < Last.beat)
                Clear();
            m_Ring[m_Next] = sample;
            m_Next = (m_Next + 1) % m_Ring.Length;
            Count = Math.Min(Count + 1, m_Ring.Length);
        }

        /// <summary>Removes all samples.</summary>
        public void Clear()
        {
            Count = 0;
            m_Next = 0;
        }

        /// <summary>Samples of the last beats in the order of their phases. Valid until the next call.</summary>
        /// <param name="lag">Beats by which what was sampled lay back.</param>
        public ReadOnlySpan<BeatSample> Fold(double lag = 0.0)
        {
            int count = 0;
            double oldest = Last.beat - m_Beats;
            for (int k = Count - 1; k >= 0 && this[k].beat >= oldest; k--)
            {
                BeatSample sample = this[k];
                m_Folded[count] = new BeatSample(sample.beat - lag, sample.flap, sample.lift);
                m_Phases[count] = m_Folded[count].Phase;
                count++;
            }

            Array.Sort(m_Phases, m_Folded, 0, count);
            return new ReadOnlySpan<BeatSample>(m_Folded, 0, count);
        }

        private static bool IsFinite(in BeatSample sample) =>
            !double.IsNaN(sample.beat) && !double.IsInfinity(sample.beat) && !float.IsNaN(sample.flap) && !float.IsInfinity(sample.flap)
            && !float.IsNaN(sample.lift) && !float.IsInfinity(sample.lift);
    }
}
