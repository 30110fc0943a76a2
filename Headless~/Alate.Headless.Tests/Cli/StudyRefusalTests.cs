using System.IO;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Study files and folders that the command <c>study</c> refuses: each in one line, and nothing is written.</summary>
public sealed class StudyRefusalTests
{
    // M is a version and a monarch, P a parameter; quotes are single.
    [TestCase("'grid' }", "not JSON")]
    [TestCase("{ M }", "'parameters' is missing")]
    [TestCase("{ 'version': 2, 'insect': 'monarch', 'parameters': [P] }", "version: 2 is out of range: 1 is allowed")]
    [TestCase("{ 'version': 1, 'insect': 'wasp', 'parameters': [P] }", "Unknown species 'wasp'")]
    [TestCase("{ M, 'parameters': [P, P] }", "'pitch' is changed twice")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pich', 'from': 0, 'to': 1 }] }", "no number 'pich'")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pitch', 'from': 0, 'to': 99 }] }",
        "'pitch' at 99: 'pitch' must lie between -90 and 90; it is 99.")]
    [TestCase("{ M, 'parameters': [{ 'key': 'insect.beat.colour', 'from': 0, 'to': 9 }] }",
        "The insect has no number 'insect.beat.colour'")]
    [TestCase("{ M, 'parameters': [{ 'key': 'insect.name', 'from': 0, 'to': 9 }] }", "The insect has no number 'insect.name'")]
    [TestCase("{ M, 'parameters': [{ 'key': 'insect.beat.frequencyHertz', 'from': 0, 'to': 9 }] }",
        "at 0: beat.frequencyHertz: 0 is out of range")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pitch', 'from': 5, 'to': 5 }] }", "'to' must be more than 'from'")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pitch', 'from': 5 }] }", "'to' is missing")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pitch', 'values': [1], 'to': 2 }] }", "it does not go with 'values'")]
    [TestCase("{ M, 'parameters': [{ 'key': 'pitch', 'from': 0, 'to': 9, 'scale': 'logarithmic' }] }", "equal ratios need values above 0")]
    [TestCase("{ M, 'design': 'sobol', 'parameters': [{ 'key': 'pitch', 'values': [1] }] }", "'values' is for a grid")]
    [TestCase("{ M, 'design': 'sobol', 'parameters': [{ 'key': 'pitch', 'from': 0, 'to': 9, 'steps': 3 }] }", "it is for a grid")]
    [TestCase("{ M, 'count': 9, 'parameters': [P] }", "a grid has as many runs as its values make")]
    [TestCase("{ M, 'parameters': [P], 'measures': ['joy'] }", "there is no measure 'joy'")]
    [TestCase("{ M, 'parameters': [P], 'measures': ['hind wing.lag_deg'] }", "there is no measure")]
    [TestCase("{ M, 'parameters': [P], 'best': { 'most': 'lift_n', 'least': 'power_w' } }",
        "best: 'lift_n' is none of the study's measures.")]
    [TestCase("{ M, 'options': ['--out', 'x'], 'parameters': [P] }", "--out is an option of 'study'")]
    [TestCase("{ M, 'options': ['--sped', '1'], 'parameters': [P] }", "options: 'fly' has no option")]
    [TestCase("{ M, 'options': ['--variant', 'biological'], 'parameters': [P] }", "There is no biological monarch")]
    [TestCase("{ M, 'parameters': [P, FINE1, FINE2] }",
        "the design has 5000000 runs")]
    [TestCase("{ M, 'design': 'search', 'parameters': [P] }", "the design 'search' and 'goal' need one another")]
    [TestCase("{ M, 'parameters': [P], 'goal': { 'most': 'lift_over_weight' } }", "the design 'search' and 'goal' need one another")]
    [TestCase("{ M, 'design': 'search', 'parameters': [P], 'goal': { 'most': 'a', 'least': 'b' } }", "it takes either 'most' or 'least'")]
    [TestCase("{ M, 'design': 'search', 'parameters': [P], 'goal': { 'most': 'lift_n' } }", "goal: 'lift_n' is none of the study's")]
    [TestCase("{ M, 'design': 'search', 'parameters': [P], 'goal': { 'most': 'lift_n', 'where': [{ 'measure': 'lift_n' }] } }",
        "it takes 'least', 'most' or both")]
    [TestCase("{ M, 'design': 'search', 'parameters': [P], 'goal': { 'most': 'x', 'where': [{ 'measure': 'x', 'least': 2, 'most': 1 }] } }",
        "'most' must be at least 'least'")]
    public void WhatIsWrong_IsOneLine_AndNothingIsWritten(string study, string problem)
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", study.Replace("FINE1", Fine("speed")).Replace("FINE2", Fine("climb"))
            .Replace("M", "'version': 1, 'insect': 'monarch'").Replace("P", "{ 'key': 'pitch', 'from': 0, 'to': 9 }").Replace('\'', '"'));
        Assert.That(run.Run("study", file, "--out", run.Out), Is.EqualTo(2), run.Errors);
        bool isOfInsect = problem.StartsWith("Unknown") || problem.StartsWith("There");
        Assert.That(run.Errors, Does.Contain(problem).And.Contain(isOfInsect ? "" : file));
        Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(Directory.Exists(run.Out), Is.False);
    }

    [Test]
    public void AFolderThatIsAFile_IsNamed_BeforeAnythingIsFlown()
    {
        using var run = new CommandRun();
        string study = $"{{ 'version': 1, 'insect': 'monarch', 'parameters': [{Fine("pitch")}] }}".Replace('\'', '"');
        string file = run.Write("s.study.json", study), taken = run.Write("taken", "");
        Assert.That(run.Run("study", file, "--out", taken), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"Cannot write into '{taken}'"));
    }

    private static string Fine(string key) => $"{{ 'key': '{key}', 'from': 0, 'to': 1, 'steps': 1000 }}";
}
