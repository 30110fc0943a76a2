using System.Linq;
using System.Reflection;
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
    public void ASlider_LiesWithinTheRangeOfItsNumber()
    {
        foreach (FlightNumber number in s_All.Where(number => number.Slider != null))
        {
            Assert.That(number.Slider.Min, Is.InRange(number.Min, number.Slider.Max), number.Name);
            Assert.That(number.Slider.Max, Is.LessThanOrEqualTo(number.Max), number.Name);
        }
    }
}
