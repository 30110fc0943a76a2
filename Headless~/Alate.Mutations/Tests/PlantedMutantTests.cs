using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Mutations.Sources;
using Alate.Mutations.Trials;
using NUnit.Framework;

namespace Alate.Mutations.Tests;

/// <summary>A whole run over an assembly that holds its own tests.</summary>
[TestFixture]
internal sealed class PlantedMutantTests
{
    private const string k_Source = """
        using NUnit.Framework;
        public static class Tiny
        {
            public const float Step = 4f;
            public static readonly float Start = 8f;
            public static float Asked(float a, float b) => a - b;
            public static float Forgotten(float a) => -a;
            public static float Lost(float a) => a / a;
            public static void Endless() { for (long i = 0; i < 9;)
                i += 1; }
            public static void Assigned(out float a) { a = 16f; }
            public static readonly float Kept = Made();
            private static float Made() => 3f * 7f;
            public static float Twin(float a) => 3f * a;
            public static float Spoiled(float a) => -a;
            public static float Shared(float a) => 5f * a;
            public static float Slow(float a) => 7f * a;
        }
        [TestFixture]
        public sealed class TinyTests
        {
            [Test] public void Always() => Assert.That(Tiny.Start, Is.Not.Zero);
            [Test] public void Asked() => Assert.That(Tiny.Asked(3f, 1f), Is.EqualTo(2f));
            [Test] public void Forgotten() { Tiny.Forgotten(1f); }
            [Test] public void Ends() => Tiny.Endless();
            [Test] public void Step() => Assert.That(Tiny.Step + Tiny.Start, Is.EqualTo(12f));
        }
        [TestFixture]
        public sealed class UpBesideTests
        {
            public sealed class Case { public float asked; }
            private static readonly Case[] s_Twins = { new Case { asked = 2f }, new Case() };
            [TestCaseSource(nameof(s_Twins))] public void Twins(Case one)
            {
                if (one.asked > 0f)
                    Assert.That(Tiny.Twin(one.asked), Is.EqualTo(6f));
            }
        }
        [TestFixture]
        public sealed class WSharedTests
        {
            private static float? s_Made;
            private static float Made() => s_Made ??= Tiny.Shared(2f);
            [Test] public void Asks() { Made(); }
            [Test] public void Checks() => Assert.That(Made(), Is.EqualTo(10f));
        }
        [TestFixture]
        public sealed class XSpoiledTests
        {
            [Test] public void Spoiled() { Tiny.Spoiled(1f); }
            [OneTimeTearDown] public void Fail() =>
                Assert.That(System.Environment.GetEnvironmentVariable("ALATE_MUTANT_HITS"), Is.Not.Null, "but where tests are recorded");
        }
        [TestFixture]
        public sealed class ZLaterTests
        {
            [Test] public void Kept() => Assert.That(Tiny.Kept, Is.EqualTo(21f));
        }
        [TestFixture, Explicit, Category("Long"), Category("Faults")]
        public sealed class SlowTests
        {
            [Test] public void Slow() => Assert.That(Tiny.Slow(2f), Is.EqualTo(14f));
            [Test, Explicit, Category("Long")] public void Slower() => Assert.Fail("it is as long as any");
        }
        [TestFixture, Explicit]
        public sealed class ExplicitTests
        {
            [Test] public void Lost() => Assert.That(Tiny.Lost(1f), Is.EqualTo(2f));
        }
        """;

    private string m_Folder;
    private List<(string Room, Mutant Mutant)> m_Drawn;
    private Coverage m_Coverage;

    [OneTimeSetUp]
    public void Build()
    {
        m_Folder = Directory.CreateTempSubdirectory("alate-tiny-").FullName;
        string here = TestContext.CurrentContext.TestDirectory;
        foreach (string file in new[] { "Alate.Mutations.dll", "nunit.framework.dll" })
            File.Copy(Path.Combine(here, file), Path.Combine(m_Folder, file));
        const string settings = ".runtimeconfig.json";
        File.Copy(Path.Combine(here, "Alate.Mutations" + settings), Path.Combine(m_Folder, "AlateTiny" + settings));
        var project = Project.Of("AlateTiny", "Tiny.cs", k_Source);
        IEnumerable<Mutant> mutants = Mutant.Of(project, project.Compilation.SyntaxTrees.Single(), "Tiny.cs")
            .Where(mutant => mutant.Line < 18);
        m_Drawn = MutationRun.Build(new Sample(mutants.Select(mutant => ("tiny", mutant)), 1), 100, [project], m_Folder);
        m_Coverage = Coverage.Record(["AlateTiny"], Worker, (_, type) => type == "ZLaterTests");
    }

    [OneTimeTearDown]
    public void Remove() => Directory.Delete(m_Folder, true);

    [Test]
    public void TheProgramAsItStands_FailsNowhere()
    {
        Assert.That(m_Coverage.Failing, Is.Empty);
        Assert.That(m_Coverage.Tests, Is.EqualTo(11), "explicit tests are run where they ask for faults");
    }

    [TestCase(6, Outcome.Found, "TinyTests.Asked")]
    [TestCase(4, Outcome.Found, "TinyTests.Step")]
    [TestCase(5, Outcome.Found, "TinyTests.Step")]
    [TestCase(7, Outcome.Survived, "")]
    [TestCase(8, Outcome.NotReached, "")]
    [TestCase(13, Outcome.Found, "ZLaterTests.Kept")]
    [TestCase(14, Outcome.Found, "UpBesideTests.Twins")]
    [TestCase(15, Outcome.NotReached, "")]
    [TestCase(16, Outcome.Found, "WSharedTests.Checks")]
    [TestCase(17, Outcome.Found, "SlowTests.Slow")]
    public void AMutant_FallsToTheTestThatAsks(int line, Outcome outcome, string test)
    {
        Verdict verdict = new Trial(m_Coverage, Worker).Of(Number(line));
        Assert.That(verdict.Outcome, Is.EqualTo(outcome));
        Assert.That(verdict.How, Does.StartWith(test));
    }

    [Test]
    public void ALoopWithoutAnEnd_IsFound()
    {
        Assert.That(new Trial(m_Coverage, Worker).Of(Number(10)).How, Does.StartWith("timeout"));
    }

    /// <summary>A dropped assignment of an out parameter does not compile.</summary>
    [Test]
    public void WhatTheCompilerRefuses_IsReplaced() => Assert.That(m_Drawn.Select(one => one.Mutant?.Before), Does.Not.Contain("a = 16f;"));

    private int Number(int line) => m_Drawn.FindIndex(one => one.Mutant?.Line == line) + 1;

    private WorkerProcess Worker() => new(m_Folder, "AlateTiny", m_Folder) { Patience = 2 };
}
