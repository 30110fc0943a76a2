using System.Collections.Generic;
using System.Linq;
using Alate.Mutations.Sources;
using NUnit.Framework;

namespace Alate.Mutations.Tests;

[TestFixture]
internal sealed class SampleTests
{
    [Test]
    public void OneSeed_DrawsOneSample() => Assert.That(Drawn(5), Is.EqualTo(Drawn(5)));

    [Test]
    public void AnotherSeed_DrawsAnother() => Assert.That(Drawn(5), Is.Not.EqualTo(Drawn(6)));

    [Test]
    public void Rooms_HaveEvenShares()
    {
        Dictionary<string, List<Mutant>> drawn = new Sample(Candidates(), 1).Draw(21);
        Assert.That(drawn.Values.Select(room => room.Count), Is.EquivalentTo(new[] { 10, 11 }));
    }

    [Test]
    public void ASampleBeyondARoom_IsAllOfIt()
    {
        Dictionary<string, List<Mutant>> drawn = new Sample(Candidates(), 1).Draw(10_000);
        // A line is drawn once.
        Assert.That(drawn["a"], Has.Count.EqualTo(20));
    }

    [TestCase("Runtime/Geometry/Filling/RimSampler.cs", "Geometry")]
    [TestCase("Runtime/Model/Forces/Drag.cs", "Model/Forces")]
    [TestCase("Editor/Authoring/Pictures/Png.cs", "Authoring")]
    [TestCase("Editor/Files/Json/JsonReader.cs", "Files")]
    [TestCase("Editor/Skeletons/Tool/Handle.cs", "Editor")]
    [TestCase("Headless~/Alate.Cli/Sweeps/Sweep.cs", "Cli/Sweeps")]
    [TestCase("Runtime/Flight/AssemblyInfo.cs", null)]
    [TestCase("Tests/Runtime/Lanes.cs", null)]
    public void AFile_HasItsRoom(string file, string room) => Assert.That(Rooms.Of(file), Is.EqualTo(room));

    [Test]
    public void WhatNoTestMeets_IsListedByFile_TheMostFirst()
    {
        string list = Report.Unmet(
            [("a", 5, true), ("b", 9, false), ("c", 7, false), ("c", 3, false), ("c", 7, false), ("c", 1, true), ("a", 6, true)]);
        Assert.That(list.ReplaceLineEndings("|"), Is.EqualTo("3 of 4  c:3,7|1 of 1  b:9|"));
    }

    [Test]
    public void Reach_IsAnOption() => Assert.That(Options.Parse(["Cli", "--reach"]).Reach, Is.True);

    private static string[] Drawn(int seed) => new Sample(Candidates(), seed).Draw(12)
        .SelectMany(room => room.Value).Select(mutant => $"{mutant.Line} {mutant.After}").ToArray();

    private static IEnumerable<(string Room, Mutant Mutant)> Candidates()
    {
        foreach (string room in new[] { "a", "b" })
        {
            string lines = string.Join('\n', Enumerable.Range(0, 20).Select(i => $"float F{i}(float a, float b) => a - b * {i + 2}f;"));
            var project = Project.Of(room, room, $"class C {{ {lines} }}");
            foreach (Mutant mutant in Mutant.Of(project, project.Compilation.SyntaxTrees.Single(), room))
                yield return (room, mutant);
        }
    }
}
