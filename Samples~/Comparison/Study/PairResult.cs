using System;
using System.Collections.Generic;
using Alate.Catalogue;

namespace Alate.Samples
{
    /// <summary>Votes between two columns: a row of the paper's Fig. 15.</summary>
    internal sealed class PairResult
    {
        private const double k_Chance = 0.5, k_SmallestShown = 0.001;

        /// <param name="one">A column.</param>
        /// <param name="other">Another.</param>
        /// <param name="votes">Of all pairs; those of others are left out.</param>
        public PairResult(ComparisonColumn one, ComparisonColumn other, IEnumerable<Vote> votes)
        {
            One = one;
            Other = other;
            var choices = new List<double>();
            foreach (Vote vote in votes)
            {
                if (!vote.IsBetween(one.Name, other.Name))
                    continue;
                choices.Add(vote.Chosen == one.Name ? 1 : 0);
                VotesForOne += vote.Chosen == one.Name ? 1 : 0;
            }

            Count = choices.Count;
            if (Count >= 2)
                Test = new OneSampleTTest(choices, k_Chance);
        }

        /// <summary>The column that <see cref="VotesForOne"/> are for.</summary>
        public ComparisonColumn One { get; }

        /// <summary>The other one.</summary>
        public ComparisonColumn Other { get; }

        /// <summary>Votes for the first.</summary>
        public int VotesForOne { get; }

        /// <summary>Votes for both.</summary>
        public int Count { get; }

        /// <summary>Test of whether the share of votes differs from a half; null with fewer than two votes.</summary>
        public OneSampleTTest? Test { get; }

        /// <summary>Returns the result in one line.</summary>
        public override string ToString()
        {
            string test = Test == null
                ? "" : Test.Value.P < k_SmallestShown ? ", p < 0.001" : FormattableString.Invariant($", p = {Test.Value.P:0.000}");
            return $"{One.Title} {VotesForOne} : {Count - VotesForOne} {Other.Title}{test}";
        }
    }
}
