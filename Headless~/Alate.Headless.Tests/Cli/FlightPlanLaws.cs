using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Effect of each number of a plan on those of a species.</summary>
public sealed class FlightPlanLaws
{
    private static WingParameters Flown(FlightPlan plan, InsectVariant variant = InsectVariant.Standard)
    {
        WingPreset preset = InsectCatalogue.Find("monarch").Wings[0].CreatePreset(ModelReading.Physical, variant);
        try
        {
            return plan.ParametersOf(preset);
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(preset);
        }
    }

    [Test]
    public void FactorsMultiply_AndOtherNumbersTakeThePlaceOfTheSpecies()
    {
        WingParameters own = Flown(new FlightPlan());
        WingParameters changed = Flown(new FlightPlan
        {
            Elasticity = 3,
            Amplitude = 0.75,
            Frequency = 1.25,
            Substeps = 36,
            Lag = 0.45,
            AddedMass = true,
            Coefficients = CoefficientSet.FlatPlate,
            TimeScheme = TimeScheme.BackwardEuler,
            HoldJoints = true,
        });

        Assert.That(changed.elasticity, Is.EqualTo(3 * own.elasticity).Within(1e-4).Percent);
        Assert.That(changed.amplitudeScale, Is.EqualTo(0.75 * own.amplitudeScale).Within(1e-4).Percent);
        Assert.That(changed.maxFrequency, Is.EqualTo(1.25 * own.maxFrequency).Within(1e-4).Percent);
        Assert.That((changed.substepsPerBeat, changed.chordDelay, changed.jointLimit), Is.EqualTo((36, 0.45f, 0f)));
        Assert.That((changed.options.addedMass, changed.options.coefficients, changed.options.timeScheme),
            Is.EqualTo((true, CoefficientSet.FlatPlate, TimeScheme.BackwardEuler)));
        Assert.That((own.substepsPerBeat, own.chordDelay, own.options.addedMass, own.jointLimit),
            Is.Not.EqualTo((36, 0.45f, true, 0f)));
        Assert.That(own.SameAs(Flown(new FlightPlan { Elasticity = 1, Amplitude = 1, Frequency = 1 })), Is.True);
    }

    // As the help of convergence says: backward Euler, 24 substeps, expressive 48, 256 patches.
    [TestCase(InsectVariant.Standard, 24)]
    [TestCase(InsectVariant.Expressive, 48)]
    public void TheOldVersion_HasTheNumbersOfTheHelp(InsectVariant variant, int substeps)
    {
        FlightPlan old = new FlightPlan { Species = "monarch", Variant = variant, Speed = 0.7 }.AsVersion01();
        WingParameters parameters = Flown(old, variant);

        Assert.That((old.Substeps, old.Patches, old.IsVersion01, old.Speed), Is.EqualTo(((int?)substeps, 256, true, 0.7)));
        Assert.That((parameters.substepsPerBeat, parameters.options.timeScheme), Is.EqualTo((substeps, TimeScheme.BackwardEuler)));
        Assert.That(Flown(old with { TimeScheme = TimeScheme.SecondOrder }, variant).options.timeScheme,
            Is.EqualTo(TimeScheme.SecondOrder), "a scheme that is asked for");
    }

    [Test]
    public void WhatLeavesTheRangeOfTheModel_IsRefused() =>
        Assert.That(() => Flown(new FlightPlan { Elasticity = 1e30 }), Throws.TypeOf<UserException>());

    [Test]
    public void SpeedsOfABody_AreThoseOfItsWay_AndWingsOfTheUsersOwnAreCounted()
    {
        Assert.That(new FlightPlan { Speed = -3, Climb = 4 }.BodySpeed, Is.EqualTo(5).Within(1e-12));
        Assert.That(new[] { new FlightPlan(), new FlightPlan { MeshFile = "a" }, new FlightPlan { MeshFile = "a", HindMeshFile = "b" } }
            .Select(plan => plan.OwnWings), Is.EqualTo(new[] { 0, 1, 2 }));
        foreach (InsectDefinition insect in InsectCatalogue.All)
        {
            WingPreset preset = insect.Wings[0].CreatePreset();
            Assert.That(FlightPlan.CruiseOf(insect), Is.EqualTo(0.65 * preset.Beat.maxSpeed).Within(5.01e-4));
            UnityEngine.Object.DestroyImmediate(preset);
        }

        Assert.That(FlightPlan.CruiseOf(InsectCatalogue.Find("monarch")), Is.EqualTo(1.3).Within(1e-9));
    }
}
