using System;
using System.Collections.Generic;
using Alate.Catalogue;

namespace Alate.Samples
{
    /// <summary>
    /// One participant's session of a paired comparison as in the paper's user study (Sec. 7.2): every pair of methods for every species,
    /// in random order, each on a random side.
    /// </summary>
    internal sealed class PairStudy
    {
        private readonly List<(string species, int left, int right)> m_Pairs = new List<(string, int, int)>();
        private readonly IReadOnlyList<ComparisonColumn> m_Methods;
        private readonly string m_Participant;
        private int m_Done;

        /// <param name="species">What is shown; the paper showed four.</param>
        /// <param name="methods">What is compared; the paper compared three, which gives three pairs for each species.</param>
        /// <param name="participant">Whose votes they are.</param>
        /// <param name="random">Decides orders and sides.</param>
        public PairStudy(IReadOnlyList<string> species, IReadOnlyList<ComparisonColumn> methods, string participant, Random random)
        {
            m_Methods = methods;
            m_Participant = participant;
            foreach (string kind in species)
            {
                for (int one = 0; one < methods.Count; one++)
                {
                    for (int other = one + 1; other < methods.Count; other++)
                        m_Pairs.Add(random.Next(2) == 0 ? (kind, one, other) : (kind, other, one));
                }
            }

            for (int k = m_Pairs.Count - 1; k > 0; k--)
            {
                int with = random.Next(k + 1);
                (m_Pairs[k], m_Pairs[with]) = (m_Pairs[with], m_Pairs[k]);
            }
        }

        /// <summary>Pairs to judge.</summary>
        public int Count => m_Pairs.Count;

        /// <summary>Pairs judged.</summary>
        public int Done => m_Done;

        /// <summary>True once all pairs are judged.</summary>
        public bool IsOver => m_Done == m_Pairs.Count;

        /// <summary>The species of the pair that is shown.</summary>
        public string Species => m_Pairs[m_Done].species;

        /// <summary>The column on the left.</summary>
        public ComparisonColumn Left => m_Methods[m_Pairs[m_Done].left];

        /// <summary>The column on the right.</summary>
        public ComparisonColumn Right => m_Methods[m_Pairs[m_Done].right];

        /// <summary>Judges the pair that is shown; the next one comes.</summary>
        /// <exception cref="InvalidOperationException">All pairs are judged.</exception>
        public Vote Choose(bool left)
        {
            if (IsOver)
                throw new InvalidOperationException($"All {Count} pairs are judged.");
            var vote = new Vote(m_Participant, Species, Left.Name, Right.Name, left ? Left.Name : Right.Name);
            m_Done++;
            return vote;
        }
    }
}
