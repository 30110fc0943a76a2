using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Studies of free flights.</summary>
public sealed class FreeStudyTests
{
    private const string k_Wander = "\"--free\", \"--pilot\", \"wander\", \"--seconds\", \"1\"",
        k_Gusts = "{ \"key\": \"gust-y\", \"values\": [-1, 1] }";

    private CommandRun m_Run;

    [SetUp]
    public void Begin() => m_Run = new CommandRun();

    [TearDown]
    public void RemoveFolder() => m_Run.Dispose();

    [Test]
    public void Repeats_FlyOneSeedAfterTheOther_AndMeasureMeanAndSpread()
    {
        string[] rows = Rows(Study(
            k_Wander + ", \"--seed\", \"7\"", k_Gusts, "power_w", "power_w_sd", "power_w_least", "power_w_most", 3));

        for (int run = 0; run < 2; run++)
        {
            double[] flown = [.. new[] { 7, 8, 9 }.Select(seed => FreeRun.Fly(
                new FreePlan
                {
                    Insect = InsectCatalogue.Find("monarch"),
                    Pilot = FreePilot.Wander,
                    Seconds = 1,
                    Seed = seed,
                    Gust = new Unity.Mathematics.float3(0f, run == 0 ? -1f : 1f, 0f),
                },
                _ => { }).MeanPower.Air)];
            double[] told = [.. rows[run + 1].Split(',').Skip(2).Take(4).Select(Number)];
            double mean = flown.Average();

            Assert.That(told[0], Is.EqualTo(mean).Within(1e-9 * mean));
            Assert.That(told[1], Is.EqualTo(Math.Sqrt(flown.Sum(one => (one - mean) * (one - mean)) / 2)).Within(1e-6 * mean));
            Assert.That((told[2], told[3]), Is.EqualTo((flown.Min(), flown.Max())));
            Assert.That(told[1], Is.GreaterThan(1e-4 * mean), "seeds differ");
        }
    }

    [Test]
    public void AGoal_MovesAlongItsAxis([Values("x", "y", "z")] string axis)
    {
        string file = Study(
            "\"--free\", \"--to\", \"0.2,0.1,0.5\", \"--seconds\", \"8\"", $"{{ \"key\": \"to-{axis}\", \"values\": [0, 0.6] }}",
            "end_x_m", "end_y_m", "end_z_m", "tumbles", 1);
        double[][] ends = [.. Rows(file).Skip(1).Select(row => row.Split(',').Skip(2).Take(3).Select(Number).ToArray())];
        int along = axis[0] - 'x';

        // A monarch climbs slowly.
        for (int k = 0; k < 3; k++)
            Assert.That(ends[1][k] - ends[0][k], k == along ? Is.InRange(0.2, 0.75) : Is.EqualTo(0.0).Within(0.15), $"{k}");
    }

    [TestCase("\"--speed\", \"0\"", k_Gusts, 1, "parameters[0].key: there is no number 'gust-y' of the flight. Known: speed, climb")]
    [TestCase(k_Wander, "{ \"key\": \"pitch\", \"values\": [1, 2] }", 1,
        "parameters[0].key: there is no number 'pitch' of a free flight. Known: seed, erratic, aid, step, gust-x")]
    [TestCase(k_Wander, "{ \"key\": \"to-x\", \"values\": [1, 2] }", 1,
        "'to-x' at 1: 'to-x' goes with --pilot goto, not with --pilot wander.")]
    [TestCase("\"--free\"", "{ \"key\": \"erratic\", \"values\": [0, 1] }", 1,
        "'erratic' at 0: 'erratic' goes with --pilot wander, not with --pilot hover.")]
    [TestCase("\"--free\"", k_Gusts, 2, "repeats: flights without --pilot wander are the same each time.")]
    [TestCase("\"--speed\", \"0\"", "{ \"key\": \"pitch\", \"values\": [1, 2] }", 2,
        "repeats: a flight on the spot is the same each time; '--free' in the options flies freely.")]
    [TestCase(k_Wander, "{ \"key\": \"gust-y\", \"values\": [-21, 1] }", 1, "'gust-y' must lie between -20 and 20; it is -21.")]
    [TestCase("\"--free\", \"--speed\", \"1\"", k_Gusts, 1, "options: --speed is for flights on the spot; it does not go with --free.")]
    [TestCase("\"--free=true\", \"--to\", \"0,0,1\"", "{ \"key\": \"pitch\", \"values\": [1, 2] }", 1,
        "options: '--free' stands alone, without a value.")]
    [TestCase("\"--free\", \"--record\", \"a.txt\"", k_Gusts, 1, "options: A study takes no --record.")]
    [TestCase(k_Wander, "{ \"key\": \"insect.massMilligrams\", \"values\": [400, 500] }", 1, "'insect.massMilligrams' at 400: ")]
    public void WhatDoesNotGoTogether_IsOneLine(string options, string parameter, int repeats, string message)
    {
        string measure = options.Contains("--free") ? "power_w" : "lift_n";
        string file = Study(options, parameter, measure, measure, measure, measure, repeats);

        Assert.That(m_Run.Run("study", file, "--out", m_Run.Out), Is.EqualTo(2));
        Assert.That(m_Run.Errors, Does.StartWith("alate: ").And.Contain(message));
        Assert.That(m_Run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
    }

    [Test]
    public void SpreadsOfOneFlight_AreNoMeasures()
    {
        string file = Study(k_Wander, k_Gusts, "power_w", "power_w_sd", "power_w", "power_w", 1);

        Assert.That(m_Run.Run("study", file, "--out", m_Run.Out), Is.EqualTo(2));
        Assert.That(m_Run.Errors, Does.Contain("there is no measure 'power_w_sd'. Known: tumbles, tumble_s, tumble_longest_s, "));
    }

    private string Study(string options, string parameter, string one, string two, string three, string four, int repeats) => m_Run.Write(
        "free.study.json",
        $"{{ \"version\": 1, \"insect\": \"monarch\", \"options\": [{options}], \"parameters\": [{parameter}],\n\"repeats\": {repeats}, "
        + $"\"measures\": [\"{one}\", \"{two}\", \"{three}\", \"{four}\"] }}");

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private string[] Rows(string file)
    {
        Assert.That(m_Run.Run("study", file, "--out", m_Run.Out), Is.Zero, m_Run.Errors);
        return File.ReadAllLines(Path.Combine(m_Run.Out, "study.csv"));
    }
}
