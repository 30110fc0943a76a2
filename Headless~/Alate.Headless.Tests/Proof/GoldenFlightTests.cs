using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Proof;
using NUnit.Framework;
using StandIns;

namespace Alate.Tests.Proof;

/// <summary>
/// The golden file of a proof. A change of the physics by intent changes it: <c>ALATE_WRITE_GOLDEN=1 dotnet test --filter GoldenFlight</c>
/// writes it.
/// </summary>
public sealed class GoldenFlightTests
{
    private const int k_MostBytes = 1_000_000;

    private static string Path => ProofSteps.GoldenPath(PackageRoot.Find());

    [Test]
    public void TheFile_HoldsWhatIsComputedHere_ToTheLastBit()
    {
        int memory = NativeMemoryLedger.LiveCount;
        List<GoldenTrack> computed = GoldenScenes.Run();
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory), NativeMemoryLedger.Describe());
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_GOLDEN") == "1")
        {
            using FileStream written = File.Create(Path);
            GoldenFile.Write(written, computed);
        }

        using FileStream file = File.OpenRead(Path);
        IReadOnlyList<GoldenTrack> golden = GoldenFile.Read(file);
        Assert.That(golden.Select(track => track.Name), Is.EqualTo(computed.Select(track => track.Name)));
        Assert.That(golden.Select(track => track.Allowed), Is.EqualTo(computed.Select(track => track.Allowed)));
        Assert.That(golden.SelectMany(track => track.Things), Is.EqualTo(computed.SelectMany(track => track.Things)));
        Assert.That(
            GoldenComparison.Lines(golden, computed).Select(line => line.measured), Is.All.EqualTo("equal to the last bit"));
        Assert.That(file.Length, Is.LessThan(k_MostBytes));
    }

    [Test]
    public void Tracks_MoveAsMuchAsAProofIsMeantToSee()
    {
        using FileStream file = File.OpenRead(Path);
        foreach (GoldenTrack track in GoldenFile.Read(file))
        {
            float[] last = track.Values[^(3 * track.Things.Length)..];
            float most = last.Zip(track.Values, (to, from) => Math.Abs(to - from)).Max();
            Assert.That(track.Samples == 1 || most > 20f * track.Allowed, Is.True, $"{track.Name} moves by {most}");
            Assert.That(track.Values, Is.All.Matches<float>(float.IsFinite), track.Name);
        }
    }
}
