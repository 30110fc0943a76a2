using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Seeds of random cases: a fixed row, so that a failure comes again.</summary>
    internal static class Seeds
    {
        private const int k_Usual = 100;

        /// <summary>Hundred seeds.</summary>
        public static IEnumerable<uint> Usual => First(k_Usual);

        /// <summary>Row of seeds without zero, which <see cref="Random"/> does not take.</summary>
        public static IEnumerable<uint> First(int count)
        {
            for (uint k = 0; k < count; k++)
                yield return Random.CreateFromIndex(k).NextUInt() | 1u;
        }
    }
}
