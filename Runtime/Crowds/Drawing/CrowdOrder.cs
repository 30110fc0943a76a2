using System;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Order of insects by their depth: two rounds of a radix sort by eight bits of the depth between nearest and farthest, so that places
    /// nearer to each other than 1/65,535 of it keep the order of the crowd. 12 bytes an insect.
    /// </summary>
    internal struct CrowdOrder : IDisposable
    {
        private const int k_Digits = 256;

        private NativeArray<int> m_Insects, m_Other;
        private NativeArray<float> m_Depths;
        private NativeArray<int> m_Starts;
        private float m_Nearest, m_Farthest;

        /// <param name="count">Most insects.</param>
        public CrowdOrder(int count)
        {
            m_Insects = new NativeArray<int>(count, Allocator.Persistent);
            m_Other = new NativeArray<int>(count, Allocator.Persistent);
            m_Depths = new NativeArray<float>(count, Allocator.Persistent);
            m_Starts = new NativeArray<int>(k_Digits, Allocator.Persistent);
            m_Nearest = m_Farthest = 0f;
            Count = 0;
        }

        /// <summary>Most insects.</summary>
        public int Length => m_Insects.Length;

        /// <summary>Insects that were added.</summary>
        public int Count { get; private set; }

        /// <summary>Insect of a place in the order.</summary>
        public int this[int place] => m_Insects[place];

        /// <summary>Forgets all insects.</summary>
        public void Begin()
        {
            Count = 0;
            m_Nearest = float.PositiveInfinity;
            m_Farthest = float.NegativeInfinity;
        }

        /// <summary>Adds an insect.</summary>
        /// <param name="insect">Its number, below the length.</param>
        /// <param name="depth">Distance along the direction of sight.</param>
        public void Add(int insect, float depth)
        {
            m_Insects[Count++] = insect;
            m_Depths[insect] = depth;
            m_Nearest = math.min(m_Nearest, depth);
            m_Farthest = math.max(m_Farthest, depth);
        }

        /// <summary>Sorts the insects that were added.</summary>
        public void SortFarthestFirst()
        {
            Distribute(m_Insects, m_Other, 0);
            Distribute(m_Other, m_Insects, 8);
        }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            m_Insects.Dispose();
            m_Other.Dispose();
            m_Depths.Dispose();
            m_Starts.Dispose();
        }

        private void Distribute(NativeArray<int> from, NativeArray<int> to, int shift)
        {
            float perUnit = 65535f / math.max(m_Farthest - m_Nearest, 1e-20f);
            for (int digit = 0; digit < k_Digits; digit++)
                m_Starts[digit] = 0;
            for (int k = 0; k < Count; k++)
                m_Starts[DigitOf(from[k], perUnit, shift)]++;
            int start = 0;
            for (int digit = 0; digit < k_Digits; digit++)
            {
                int count = m_Starts[digit];
                m_Starts[digit] = start;
                start += count;
            }

            for (int k = 0; k < Count; k++)
                to[m_Starts[DigitOf(from[k], perUnit, shift)]++] = from[k];
        }

        private int DigitOf(int insect, float perUnit, int shift) =>
            ((int)math.min((m_Farthest - m_Depths[insect]) * perUnit, 65535f) >> shift) & (k_Digits - 1);
    }
}
