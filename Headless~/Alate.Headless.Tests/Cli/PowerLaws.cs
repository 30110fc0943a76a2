using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Laws of the powers of wings in <c>forces.csv</c>: of the air, of the wings' own mass, positive and negative.</summary>
public sealed unsafe class PowerLaws
{
    private FlightRecord m_Flown;
    private Dictionary<string, double[]> m_Table;

    [OneTimeSetUp]
    public void Fly()
    {
        m_Flown = TetheredFlight.Fly(new FlightPlan
        {
            Species = "dragonfly",
            Variant = InsectVariant.Flight,
            Speed = 1,
            Climb = 0.25,
            PitchDegrees = 10,
            Substeps = 240,
            Patches = 128,
            RecordsAir = true,
            AddedMass = true,
        });
        m_Table = Table(ForceTable.Of(m_Flown));
    }

    /// <summary>Force of each patch times the velocity of its joints by their places before and after.</summary>
    [Test]
    public void ThePowerOfTheAir_IsLessTheForceTimesTheVelocity_OfEachWing()
    {
        foreach (RecordedWing wing in m_Flown.Wings)
        {
            double unit = UnitOf(wing);
            double[] ours = m_Table[Column(wing, "power_w")], expected = Each(wing, k =>
                -unit * wing.Frames[k].AirLoads.Select((load, joint) => math.dot(load, Velocity(wing, k, joint))).Sum());
            AssertAlike(ours, expected, 0.03, wing.SideAndName);
            Assert.That(ours.Average(), Is.EqualTo(expected.Average()).Within(2).Percent);
            Assert.That(ours.Average(), Is.Positive, "wings push the air");
        }
    }

    /// <summary>Rate of ½ Σ m v² by the joints' places, with the masses of the rig.</summary>
    [Test]
    public void TheInertialPower_IsTheRateOfTheKineticEnergy_OfEachWing()
    {
        foreach (RecordedWing wing in m_Flown.Wings)
        {
            double unit = UnitOf(wing), rate = wing.Frames.Count * wing.Frequency;
            float[] masses = Masses(wing);
            Assert.That(masses.Sum(), Is.EqualTo(1f).Within(1e-5f));
            double[] energy = Each(wing, k =>
                0.5 * unit * masses.Select((mass, joint) => mass * math.lengthsq(Velocity(wing, k, joint))).Sum());
            int count = energy.Length;
            double[] expected = Each(wing, k => 0.5 * rate * (energy[(k + 1) % count] - energy[(k + count - 1) % count]));
            AssertAlike(m_Table[Column(wing, "inertial_power_w")], expected, 0.06, wing.SideAndName);
        }
    }

    [Test]
    public void TheMeanInertialPower_OfASettledBeat_IsZero()
    {
        foreach (string column in m_Flown.Wings.Select(wing => Column(wing, "inertial_power_w")).Append("inertial_power_w"))
        {
            double[] inertial = m_Table[column];
            Assert.That(inertial.Average(), Is.Zero.Within(0.01 * inertial.Average(Math.Abs)), column);
            Assert.That(inertial.Max(), Is.Positive);
        }
    }

    [Test]
    public void PositiveAndNegativePower_AreBothPowersTogether_OneOfThemAtATime()
    {
        foreach (RecordedWing wing in m_Flown.Wings)
        {
            double[] both = m_Table[Column(wing, "power_w")].Zip(m_Table[Column(wing, "inertial_power_w")], (a, b) => a + b).ToArray();
            double[] positive = m_Table[Column(wing, "positive_power_w")], negative = m_Table[Column(wing, "negative_power_w")];
            double size = both.Max(Math.Abs);
            for (int k = 0; k < both.Length; k++)
            {
                Assert.That(positive[k], Is.EqualTo(Math.Max(both[k], 0)).Within(1e-5 * size), "a row is one substep");
                Assert.That(negative[k], Is.EqualTo(Math.Min(both[k], 0)).Within(1e-5 * size));
            }

            double air = m_Table[Column(wing, "power_w")].Average();
            Assert.That(positive.Average() + negative.Average(), Is.EqualTo(air).Within(0.5).Percent, "the work of a settled beat");
            Assert.That(negative.Min(), Is.LessThan(-0.01 * size), "the wing is braked at the end of a half stroke");
        }
    }

    [Test]
    public void ThePowersOfAll_AreTheSumsOverTheWings()
    {
        foreach (string power in new[] { "power_w", "inertial_power_w", "positive_power_w", "negative_power_w" })
        {
            double[][] wings = m_Flown.Wings.Select(wing => m_Table[Column(wing, power)]).ToArray();
            for (int k = 0; k < m_Table[power].Length; k++)
                Assert.That(m_Table[power][k], Is.EqualTo(wings.Sum(wing => wing[k])).Within(1e-6 * m_Table["positive_power_w"].Max()));
        }
    }

    /// <summary>
    /// Work of one time in steps of many substeps and in steps of one: no substep's work is lost, and none counts with another sign.
    /// </summary>
    [Test]
    public void TheMeansOfALongStep_AreThoseOfItsSubsteps()
    {
        FlightPlan plan = new() { Species = "monarch", Substeps = 48, Patches = 64 };
        using var one = new TetheredWings(plan, Insect.Of(plan));
        using var many = new TetheredWings(plan, Insect.Of(plan));
        double substep = 1.0 / (48 * one.Read(0).Frequency);
        for (int step = 0; step < 4; step++)
        {
            many.World.Step((float)(24 * substep));
            WingPower sum = default;
            for (int k = 0; k < 24; k++)
            {
                one.World.Step((float)substep);
                sum += WingPower.Of(one.Read(0), 1.0, 1.0);
            }

            var whole = WingPower.Of(many.Read(0), 24.0, 1.0);
            Assert.That(whole.Air, Is.EqualTo(sum.Air).Within(0.1).Percent);
            Assert.That(whole.Positive, Is.EqualTo(sum.Positive).Within(0.1).Percent);
            Assert.That(whole.Inertial, Is.EqualTo(sum.Inertial).Within(1e-3 * sum.Positive));
            Assert.That(whole.Negative, Is.EqualTo(sum.Negative).Within(1e-3 * sum.Positive));
            if (step > 0)
                Assert.That(sum.Negative, Is.Negative, "half a beat has both");
        }
    }

    [Test]
    public void AFreeFlight_HasThePowersOfItsWings_WhichSumUpToThatOfTheBody()
    {
        FreePlan plan = new() { Insect = InsectCatalogue.Find("dragonfly"), Pilot = FreePilot.Hover, Seconds = 0.2, Step = 0.01 };
        FreeRecord record = FreeRun.Fly(plan, _ => { });
        Dictionary<string, double[]> table = Table(ForceTable.Of(record));

        Assert.That(record.WingNames,
            Is.EqualTo(new[] { "right fore wing", "left fore wing", "right hind wing", "left hind wing" }));
        Assert.That(table["power_w"], Is.EqualTo(record.Moments.Select(at => at.Power)).Within(1e-3).Percent);
        for (int k = 0; k < table["time_s"].Length; k++)
        {
            Assert.That(table["positive_power_w"][k], Is.GreaterThanOrEqualTo(0));
            Assert.That(table["negative_power_w"][k], Is.LessThanOrEqualTo(0));
            Assert.That(table["positive_power_w"][k] + table["negative_power_w"][k],
                Is.EqualTo(table["power_w"][k] + table["inertial_power_w"][k]).Within(1e-5 * table["positive_power_w"].Max()));
        }

        Assert.That(table["positive_power_w"].Average(), Is.GreaterThan(table["power_w"].Average()));
    }

    [Test]
    public void TheSummary_HasTheMeansOverTheBeat()
    {
        var summary = FlightSummary.Of(m_Flown);

        Assert.That(summary.MeanPower.Air, Is.EqualTo(m_Table["power_w"].Average()).Within(1e-3).Percent);
        Assert.That(summary.MeanPower.Positive, Is.EqualTo(m_Table["positive_power_w"].Average()).Within(1e-3).Percent);
        Assert.That(summary.MeanPower.Negative, Is.EqualTo(m_Table["negative_power_w"].Average()).Within(1e-2).Percent);
    }

    private static void AssertAlike(double[] ours, double[] expected, double share, string name)
    {
        double off = Math.Sqrt(ours.Zip(expected, (a, b) => (a - b) * (a - b)).Average()), size = Math.Sqrt(expected.Average(a => a * a));
        Assert.That(off, Is.LessThan(share * size), $"{name}: {off / size:0.000} of the root mean square");
    }

    private static float3 Velocity(RecordedWing wing, int k, int joint)
    {
        int count = wing.Frames.Count;
        return 0.5f * count * wing.Frequency
            * (wing.Frames[(k + 1) % count].Joints[joint] - wing.Frames[(k + count - 1) % count].Joints[joint]);
    }

    private static double[] Each(RecordedWing wing, Func<int, double> value) =>
        Enumerable.Range(0, wing.Frames.Count).Select(value).ToArray();

    private static double UnitOf(RecordedWing wing)
    {
        double length = wing.Wing.Preset.Size.wingLength;
        return wing.Wing.Preset.Size.wingMass * length * length;
    }

    private static float[] Masses(RecordedWing wing)
    {
        var rig = WingRig.Bake(wing.Wing.Skeleton, wing.Wing.Surface, WingRigSettings.Default);
        float[] masses = new ReadOnlySpan<float>(rig.View.jointMasses, rig.View.jointCount).ToArray();
        rig.Release();
        return masses;
    }

    private static string Column(RecordedWing wing, string power) => $"{wing.SideAndName.Replace(' ', '_')}_{power}";

    internal static Dictionary<string, double[]> Table(IEnumerable<IReadOnlyList<string>> rows)
    {
        IReadOnlyList<string>[] all = rows.ToArray();
        double[] Cells(int column) =>
            all.Skip(1).Select(row => double.Parse(row[column], System.Globalization.CultureInfo.InvariantCulture)).ToArray();
        return Enumerable.Range(0, all[0].Count).Where(column => all[0][column] != "half_stroke")
            .ToDictionary(column => all[0][column], Cells);
    }
}
