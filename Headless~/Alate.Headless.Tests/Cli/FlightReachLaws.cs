using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>An insect that cannot hover or climb by its table is told so, with the speeds at which it moves level.</summary>
    public sealed class FlightReachLaws
    {
        private static readonly float[] s_Speeds = [0f, 0.3f, 0.65f, 1f], s_Climbs = [-0.3f, 0f, 0.3f];

        // [speed] Climbs that close: s for the slow sinking, l for level, c for the climb.
        [TestCase("slc slc slc slc", null)]
        [TestCase("sl l lc s", null)]
        [TestCase("sl sl sl s", "moves level at 0 to 0.65 m/s and cannot climb")]
        [TestCase("s sl slc sl", "moves level at 0.3 to 1 m/s and cannot hover")]
        [TestCase("c sc - -", "moves level at 0.3 to 0.3 m/s and cannot hover")]
        [TestCase("s sl sl s", "moves level at 0.3 to 0.65 m/s and can neither hover nor climb")]
        [TestCase("s s - s", "sinks at every speed")]
        public void WhatIsMissing_IsSaid(string closed, string said)
        {
            using var table = new TrimTable(s_Speeds, s_Climbs);
            string[] speeds = closed.Split(' ');
            for (int s = 0; s < speeds.Length; s++)
            {
                for (int c = 0; c < s_Climbs.Length; c++)
                {
                    if (speeds[s].Contains("slc"[c]))
                        table.Set(s, c, []);
                }
            }

            Assert.That(FlightReach.Missing(table), said == null ? Is.Null : Is.EqualTo("by its trim table it " + said));
        }

        [TestCase("snailfish", true)]
        [TestCase("monarch", false)]
        [TestCase("dragonfly", false)]
        public void AFreeFlight_SaysIt(string species, bool says)
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", species, "--free", "--seconds", "0.1", "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(
                run.Output, says ? Does.Contain("moves level at 0.1 to 0.25 m/s and cannot hover") : Does.Not.Contain("moves level"));
        }
    }
}
