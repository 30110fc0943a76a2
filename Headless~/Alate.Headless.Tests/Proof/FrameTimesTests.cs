using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Proof;
using NUnit.Framework;
using StandIns;
using Unity.Jobs.LowLevel.Unsafe;

namespace Alate.Tests.Proof;

/// <summary>Times of frames in an editor: what is set for them, and put back.</summary>
public sealed class FrameTimesTests
{
    private const string k_Off = "Jobs/Burst/Safety Checks/Off", k_On = "Jobs/Burst/Safety Checks/On";

    [TearDown]
    public void Forget() => RunningEditor.MenuItem = null;

    [Test]
    public void WithoutBurstsMenu_NothingIsTimed_AndEveryClaimIsTold([Values] bool debugger)
    {
        bool before = JobsUtility.JobDebuggerEnabled;
        List<string> chosen = [];
        RunningEditor.MenuItem = item =>
        {
            chosen.Add($"{item} {JobsUtility.JobDebuggerEnabled}");
            return false;
        };
        try
        {
            JobsUtility.JobDebuggerEnabled = debugger;
            List<ProofLine> lines = [.. FrameTimes.Measure()];
            Assert.That(lines[0].what, Is.EqualTo("Burst compiles the jobs"));
            Assert.That((lines[0].state, lines[0].measured, lines[0].allowed), Is.EqualTo((ProofState.Differs, "off", "on")));
            Assert.That(lines.Skip(1).Select(line => line.what), Is.EqualTo(FrameTimes.Claims()));
            Assert.That(lines.Skip(1).Select(line => line.state), Is.All.EqualTo(ProofState.NotTried));
            Assert.That(chosen, Is.EqualTo(new[] { $"{k_Off} False", $"{k_On} True", $"{k_On} {debugger}" }));
            Assert.That(JobsUtility.JobDebuggerEnabled, Is.EqualTo(debugger));
        }
        finally
        {
            JobsUtility.JobDebuggerEnabled = before;
        }
    }

    // One insect alone is told, and held whatever it takes; its frame lasts as long as it does.
    [Test]
    public void OneInsect_IsTimed_AndNotJudged()
    {
        RunningEditor.MenuItem = _ => true;
        int memory = NativeMemoryLedger.LiveCount;
        ProofLine line = FrameTimes.Measure().Skip(1).First();
        Assert.That((line.what, line.state, line.allowed, line.note),
            Is.EqualTo(("frame of 1 monarch, safety checks off", ProofState.Held, "", "headless 50 µs")));
        Match told = Regex.Match(line.measured, @"^(\d+\.\d) µs an insect, (\d+\.\d\d) ms$");
        Assert.That(told.Success, line.measured);
        double each = double.Parse(told.Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture);
        double frame = double.Parse(told.Groups[2].Value, System.Globalization.CultureInfo.InvariantCulture);
        Assert.That(each, Is.GreaterThan(1.0));
        Assert.That(1000.0 * frame, Is.EqualTo(each).Within(5.1), "of one insect");
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory));
    }

    [Test]
    public void ClaimsAre_ForFourCrowds_WithoutAndWithSafetyChecks() => Assert.That(FrameTimes.Claims(), Is.EqualTo(
        new[] { "off", "on" }.SelectMany(safety => new[] { "1 monarch", "100 monarchs", "400 monarchs", "1000 monarchs" }
            .Select(crowd => $"frame of {crowd}, safety checks {safety}"))));
}
