using FsCheck;

namespace Alate.Tests
{
    /// <summary>Runs of properties over random cases that are equal each time.</summary>
    internal static class FixedRuns
    {
        /// <summary>
        /// Hundred cases, or fewer, of one seed. A failure names the seed of its case, with which FsCheck makes it again.
        /// </summary>
        public static Config Of(int cases = 100, ulong seed = 1) => Config.QuickThrowOnFailure.WithMaxTest(cases).WithReplay(seed, 1);
    }
}
