using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Descriptions of a flight's numbers against the plans that they read and change.</summary>
public sealed class FlightNumbersTests
{
    private static readonly FlightNumber[] s_All = typeof(FlightNumbers).GetProperties(BindingFlags.Public | BindingFlags.Static)
        .Select(property => (FlightNumber)property.GetValue(null)).ToArray();

    [Test]
    public void WhatAPlanIsGiven_IsWhatIsRead_AtBothEndsOfEachRange()
    {
        foreach (FlightNumber number in s_All.Where(number => number.In != null))
        {
            foreach (double value in new[] { number.Min, number.Max })
                Assert.That(number.Of(number.In(new FlightPlan(), value)), Is.EqualTo(value), number.Name);
        }
    }

    [Test]
    public void EachNumber_ChangesItself_AndNoOther()
    {
        FlightNumber[] planned = s_All.Where(number => number.In != null).ToArray();
        foreach (FlightNumber number in planned)
        {
            FlightPlan plan = number.In(new FlightPlan(), number.Max);
            foreach (FlightNumber other in planned.Where(other => other != number))
                Assert.That(other.Of(plan), Is.EqualTo(other.Of(new FlightPlan())), $"{number.Name}, {other.Name}");
        }
    }

    [Test]
    public void APlanThatIsToldNothing_HasTheDefaults()
    {
        foreach (FlightNumber number in s_All.Where(number => number.Of != null && number != FlightNumbers.Speed))
            Assert.That(number.Of(new FlightPlan()), Is.EqualTo(number.Default), number.Name);
        Assert.That(new FreePlan().Step, Is.EqualTo(FlightNumbers.Step.Default));
    }

    [Test]
    public void ANumberOfThreeAxes_ReachesAsFarBothWays()
    {
        FlightNumber[] places = s_All.Where(number => number.Word == "X,Y,Z").ToArray();
        Assert.That(places, Has.Length.GreaterThan(2));
        foreach (FlightNumber number in places)
            Assert.That(number.Min, Is.EqualTo(-number.Max).And.Negative, number.Name);
    }

    [Test]
    public void RangesOfTheSliders_AreThoseOfTheManual()
    {
        string page = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", "live-view.md"));
        (double, double)[] Told(string row) => Regex.Matches(
            Regex.Match(page, $@"^\| {row} \|(.*)$", RegexOptions.Multiline).Groups[1].Value, @"(−?[\d.]+) to ([\d.]+)")
            .Select(range => (Number(range.Groups[1].Value), Number(range.Groups[2].Value))).ToArray();
        double Number(string text) => double.Parse(text.Replace('−', '-'), CultureInfo.InvariantCulture);
        (double, double)[] Of(params string[] names) =>
            [.. names.Select(name => ViewSlider.All.Single(slider => slider.Name == name)).Select(slider => (slider.Min, slider.Max))];

        Assert.That(Of("slow"), Is.EqualTo(Told("slow motion")));
        Assert.That(Of("speed", "wind"), Is.EqualTo(Told("speed, head wind")));
        Assert.That(Of("elasticity", "amplitude", "frequency"), Is.EqualTo(Told("elasticity, amplitude, frequency")));
        Assert.That(Of("delay"), Is.EqualTo(Told("delay of the trailing edge")));
        Assert.That(Of("substeps"), Is.EqualTo(new[] { ((double)WingParameters.MinSubsteps, (double)WingParameters.MaxSubsteps) }));
        // Equal ways are equal ratios where a factor is asked for, from nought on equal differences.
        Assert.That(ViewSlider.All.Where(slider => slider.IsLogarithmic).Select(slider => slider.Name),
            Is.EquivalentTo(new[] { "slow", "elasticity", "frequency", "substeps" }));
    }

    [Test]
    public void ASlider_LiesWithinTheRangeOfItsNumber()
    {
        foreach (FlightNumber number in s_All.Where(number => number.Slider != null))
        {
            Assert.That(number.Slider.Min, Is.InRange(number.Min, number.Slider.Max), number.Name);
            Assert.That(number.Slider.Max, Is.LessThanOrEqualTo(number.Max), number.Name);
        }
    }
}
