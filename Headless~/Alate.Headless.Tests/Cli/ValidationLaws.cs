using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Numbers behind the rows of comparisons with measurements, beside sums over the frames and closed forms.</summary>
public sealed class ValidationLaws
{
    private FlightRecord m_Flight;

    [OneTimeSetUp]
    public void Fly() => m_Flight = TetheredFlight.Fly(new FlightPlan
    {
        Species = "monarch",
        Speed = 1.3,
        PitchDegrees = 25,
        Substeps = 24,
        Patches = 64
    });

    [Test]
    public void ThrustOfAHeldFlight_IsItsMeanForceAlongItsWay_OverItsWeight()
    {
        double force = 0.0, pitch = 25 * Math.PI / 180;
        foreach (RecordedWing wing in m_Flight.Wings)
        {
            force += wing.Frames.Average(frame => (Math.Cos(pitch) * frame.AirForce.z - Math.Sin(pitch) * frame.AirForce.y)
                * wing.Wing.Preset.Size.wingMass * wing.Wing.Preset.Size.wingLength);
        }

        Assert.That(ButterflyRows.Thrust(m_Flight),
            Is.EqualTo(force / (9.81 * m_Flight.Wings[0].Wing.Preset.Size.insectMass)).Within(1e-4));
    }

    [Test]
    public void TwistsAndCambers_AreOfTheUpstrokeOverTheDownstroke_AndTheSmallerMeanWhereBothHaveOneSign()
    {
        RecordedWing wing = m_Flight.Wings[0];
        double Most(bool down) => wing.Frames.Where(frame => frame.Phase < Math.PI == down).Max(frame =>
            Math.Abs(wing.Measurement.Twist(frame.Positions)));
        double Mean(bool down) => wing.Frames.Where(frame => frame.Phase < Math.PI == down).Average(frame =>
            (double)wing.Measurement.Camber(frame.Positions));
        double one = 100 * Mean(true), other = 100 * Mean(false);

        Assert.That(ButterflyRows.Twists(m_Flight), Is.EqualTo(Most(false) / Most(true)).Within(1e-6));
        // Means of frames miss the ends of the half strokes by half a frame.
        double told = ButterflyRows.Cambers(m_Flight),
            whole = wing.Frames.Max(frame => 100.0 * Math.Abs(wing.Measurement.Camber(frame.Positions)));
        Assert.That(Math.Abs(told), Is.EqualTo(Math.Min(Math.Abs(one), Math.Abs(other))).Within(0.1 * whole));
        Assert.That(told < 0, Is.EqualTo(one * other < 0));
        Assert.That((ButterflyRows.Degrees(Math.PI / 3), ButterflyRows.Radians(90), ButterflyRows.Degrees(null)),
            Is.EqualTo((60.0, Math.PI / 2, double.NaN)).Using<(double, double, double)>((a, b) =>
                Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-9 && double.IsNaN(a.Item3) == double.IsNaN(b.Item3)));
    }

    // A light beam droops by an eighth of its weight, q L⁴ / 8 E I; hinges in place of a curve are within three hundredths of it.
    [Test]
    public void ALightStrip_DroopsByAnEighthOfItsWeight_PerCentOfItsLength()
    {
        ValidationRow row = StructureRows.Droops(new Fineness(24, 48), () => { }).First();

        Assert.That(row.Title, Does.Contain("under a weight of 0.016 EI/L²"));
        Assert.That((row.Low + row.High) / 2, Is.EqualTo(100 * 0.016 / 8).Within(0.5).Percent);
        Assert.That((row.High - row.Low) / (row.High + row.Low), Is.EqualTo(0.03).Within(1e-6));
        Assert.That(row.Ours, Is.InRange(row.Low, row.High));
        Assert.That(row.Fine, Is.InRange(row.Low, row.High));
    }

    // Places within a tenth of a beat of the middle, over the end of the beat too.
    [TestCase(0.44, new[] { 4, 5 })]
    [TestCase(0.5, new[] { 4, 5, 6 })]
    [TestCase(0.94, new[] { 9, 0 })]
    [TestCase(0.0, new[] { 9, 0, 1 })]
    public void TheMiddleOfAStroke_IsATenthOfABeatAround(double middle, int[] places)
    {
        double[] curve = [.. Enumerable.Range(0, 10).Select(k => (double)(1 << k))];

        Assert.That(DragonflyCurves.Stroke(curve, middle), Is.EqualTo(places.Average(k => curve[k])).Within(1e-9));
    }

    // Half strokes of a beat on the spot, beside sums over its frames.
    [Test]
    public void HalfStrokesOfABeat_AreThoseOfItsFrames()
    {
        FlightRecord flight = TetheredFlight.Fly(m_Flight.Plan with { RecordsAir = true });
        double weight = 9.81 * flight.Wings[0].Wing.Preset.Size.insectMass, pitch = 25 * Math.PI / 180, down = 0, all = 0, power = 0;
        var attacks = new List<double>();
        foreach (RecordedWing wing in flight.Wings)
        {
            double unit = wing.Wing.Preset.Size.wingMass * wing.Wing.Preset.Size.wingLength;
            foreach (RecordedFrame frame in wing.Frames)
            {
                double up = unit * (Math.Cos(pitch) * frame.AirForce.y + Math.Sin(pitch) * frame.AirForce.z) / wing.Frames.Count / weight;
                all += up;
                down += frame.Phase < Math.PI ? up : 0;
                power += frame.Power.Air / wing.Frames.Count / (weight / 9.81);
            }
        }

        var strokes = HalfStrokes.Of(flight, weight);
        Assert.That(strokes.DownImpulse, Is.EqualTo(100 * down).Within(0.1).Percent);
        Assert.That(down, Is.GreaterThan(0.5 * all));
        Assert.That(strokes.Stored, Is.EqualTo(power).Within(0.1).Percent);
        Assert.That(strokes.Unstored, Is.GreaterThanOrEqualTo(strokes.Stored), "what is given back helps");
        // A mean over the wing lies between its strips.
        foreach ((double middle, double told) in new[] { (0.25, strokes.DownAttack), (0.75, strokes.UpAttack) })
        {
            List<double> strips = [.. flight.Wings[0].Frames.Where(frame => Math.Abs(frame.Phase / (2 * Math.PI) - middle) < 0.05)
                .SelectMany(frame => frame.Strips).Where(strip => strip.Area > 0).Select(strip => 180 / Math.PI * strip.Attack)];
            Assert.That(told, Is.InRange(strips.Min(), strips.Max()));
            Assert.That(told, Is.EqualTo(strips.Average()).Within(6));
        }
    }

    [Test]
    public void TheAttackOfAHalfStroke_IsTheMeanOverTheAreaOfLongAndShortWings()
    {
        FlightRecord flight = TetheredFlight.Fly(
            new FlightPlan { Species = "dragonfly", Speed = 1.3, Substeps = 24, Patches = 64, RecordsAir = true });
        var means = new List<double>();
        for (int k = 0; k < flight.Wings[0].Frames.Count; k++)
        {
            if (Math.Abs(flight.Wings[0].Frames[k].Phase / (2 * Math.PI) - 0.25) >= 0.05)
                continue;
            List<(double Area, double Attack)> strips = [.. flight.Wings.SelectMany(wing => wing.Frames[k].Strips
                .Where(strip => strip.Area > 0)
                .Select(strip => (strip.Area * Math.Pow(wing.Wing.Preset.Size.wingLength, 2), (double)strip.Attack)))];
            means.Add(strips.Sum(strip => strip.Area * strip.Attack) / strips.Sum(strip => strip.Area));
        }

        double weight = 9.81 * flight.Wings[0].Wing.Preset.Size.insectMass;
        Assert.That(flight.Wings.Select(wing => wing.Wing.Preset.Size.wingLength).Distinct().Count(), Is.EqualTo(2));
        Assert.That(HalfStrokes.Of(flight, weight).DownAttack, Is.EqualTo(180 / Math.PI * means.Average()).Within(1e-3));
    }

    // Half of a last digit of one number alone moves the lift by less than the band; the band of finer digits is narrower.
    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void LastDigits_LeaveABandThatHoldsEachOfThem()
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Flights[1];
        (double lift, double thrust) = LastDigits.Of(flight);
        double Lift(MeasuredDragonfly changed) =>
            BladeElements.Curve(changed, BladeElements.Point.MidChord, ownDrag: true).Average(moment => moment.Lift);
        double faster = Lift(flight with { Speed = flight.Speed + 0.05 }) - Lift(flight),
            heavier = Lift(flight with { Mass = flight.Mass + 5e-6 }) - Lift(flight);

        Assert.That(lift, Is.GreaterThan(1.96 * Math.Sqrt((faster * faster + heavier * heavier) / 3)).And.LessThan(0.12));
        Assert.That(thrust, Is.GreaterThan(0.01).And.LessThan(0.12));
        Assert.That(LastDigits.Of(flight with { HalfSpeed = 0.5 }).Lift, Is.GreaterThan(lift));
    }

    [Test]
    public void Correlations_AreOneForLines_MinusOneForFallingOnes_AndLeaveOutHoles()
    {
        double[] a = [1, 2, 4, 7, 11];

        Assert.That(DragonflyCurves.Correlation(a, [.. a.Select(value => 3 * value - 20)]), Is.EqualTo(1).Within(1e-12));
        Assert.That(DragonflyCurves.Correlation(a, [.. a.Select(value => 5 - value)]), Is.EqualTo(-1).Within(1e-12));
        // Pearson's, of the deviations −1, 0, 1 and 1, −2, 1: they are at right angles.
        Assert.That(DragonflyCurves.Correlation([1, 2, 3], [3, 0, 3]), Is.Zero.Within(1e-12));
        Assert.That(DragonflyCurves.Correlation([1, 2, 3, 100], [3, 0, 6, double.NaN]), Is.EqualTo(3 / Math.Sqrt(2 * 18)).Within(1e-12));
    }

    // A table in steps of five degrees, straight between: the mean of two neighbours lies in the middle, and slopes go on within a step.
    [Test]
    public void ADragonflysDrag_IsStraightBetweenTheAnglesOfItsTable_AndRisesToTwo()
    {
        for (int step = 0; step < 18; step++)
        {
            double from = BladeElements.OwnDrag(5 * step), to = BladeElements.OwnDrag(5 * step + 4.999999);
            Assert.That(BladeElements.OwnDrag(5 * step + 2.5), Is.EqualTo(0.5 * (from + to)).Within(1e-6));
            Assert.That(BladeElements.OwnDrag(5 * step + 1), Is.EqualTo(0.8 * from + 0.2 * to).Within(1e-6));
            Assert.That(to - from, Is.InRange(0.004, 0.26), "it rises, without a leap");
            Assert.That(step < 17 ? BladeElements.OwnDrag(5 * step + 5) - to : 0, Is.EqualTo(0).Within(1e-6));
        }

        Assert.That((BladeElements.OwnDrag(0), BladeElements.OwnDrag(90)), Is.EqualTo((0.094, 2.0)), "as published: 0.09 along, 2 across");
    }

    // The report of the manual has the published series as they were read off the plots.
    [Test]
    public void MeasuredSeries_AreThoseOfTheReport()
    {
        string path = System.IO.Path.Combine(PackageRoot.Find(), "Documentation~", "validation.json");
        System.Text.Json.JsonElement[] curves =
            [.. System.Text.Json.JsonDocument.Parse(System.IO.File.ReadAllText(path)).RootElement.GetProperty("curves").EnumerateArray()];
        foreach ((string key, IReadOnlyList<double> series) in new[]
        {
            ("vertical-force", MeasuredDragonfly.TetheredForce), ("angle-of-attack", MeasuredDragonfly.TetheredAttack),
        })
        {
            double[] told = [.. curves.Single(curve => curve.GetProperty("key").GetString() == key).GetProperty("measured").EnumerateArray()
                .Select(number => number.ValueKind == System.Text.Json.JsonValueKind.Null ? double.NaN : number.GetDouble())];
            Assert.That(told, Is.EqualTo(series).Within(1e-6));
        }
    }

    // Flaps from end to end and stroke planes off the horizontal, of a trim that scales the beat and leans it back.
    [Test]
    public void TheBeatOfATrim_IsToldInDegrees_ForEachKindOfWing()
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("dragonfly"));
        using var solver = new TrimSolver(model);
        TrimState trim = solver.Start();
        trim.z[0] = 0.3;
        trim.z[2] = 1.25;
        trim.z[3] = -0.1;
        FlightWing[] right = [.. model.Wings.Where(wing => !wing.IsLeft)];
        double[] flaps = FlightFigures.Flaps(model, trim), planes = FlightFigures.Planes(model, trim);
        for (int k = 0; k < 2; k++)
        {
            Assert.That(flaps[k] * Math.PI / 180, Is.EqualTo(2 * 1.25 * right[k].Parameters.amplitude.x).Within(1e-6));
            Assert.That((90 - planes[k]) * Math.PI / 180, Is.EqualTo(right[k].Parameters.tilt + 0.3 - 0.1).Within(1e-6));
        }

        Assert.That(FlightFigures.Beat(33.44, [70.4, 60.6], [40.2, 30.7], "5°"),
            Is.EqualTo(new[] { "33.4", "70°", "61°", "40°", "31°", "5°" }));
        Assert.That((FlightFigures.Percent(0.125 + 0.001), FlightFigures.Percent(-0.25)), Is.EqualTo(("13 %", "−25 %")));
    }

    // The lift of the tethered dragonfly, in weights: the force of four wings, left ones mirrored.
    [Test]
    public void ARunOfADragonfly_HasItsForcesOverItsWeight_AndItsPowerOverItsMass()
    {
        MeasuredDragonfly measured = MeasuredDragonfly.Flights[1];
        var run = DragonflyRun.Fly(measured, false, 24);
        int count = run.Record.Wings[0].Frames.Count;
        for (int k = 0; k < count; k++)
        {
            double up = 0, ahead = 0, power = 0;
            foreach (RecordedWing wing in run.Record.Wings)
            {
                double mass = wing.Wing.Preset.Size.wingMass, length = wing.Wing.Preset.Size.wingLength;
                RecordedFrame frame = wing.Frames[k];
                up += mass * length * frame.AirForce.y;
                ahead += mass * length * frame.AirForce.z;
                // Loads against the way of their joints, from the frame before to the one behind.
                float3[] before = wing.Frames[(k + count - 1) % count].Joints, after = wing.Frames[(k + 1) % count].Joints;
                double time = 2.0 / (count * wing.Frequency);
                for (int joint = 0; joint < before.Length; joint++)
                    power -= mass * length * length * math.dot(frame.AirLoads[joint], after[joint] - before[joint]) / time;
            }

            Assert.That(run.Lift[k], Is.EqualTo(up / (9.81 * 790e-6)).Within(1e-4 + 1e-4 * Math.Abs(run.Lift[k])));
            Assert.That(run.Thrust[k], Is.EqualTo(ahead / (9.81 * 790e-6)).Within(1e-4 + 1e-4 * Math.Abs(run.Thrust[k])));
            Assert.That(run.Power[k], Is.EqualTo(power / 790e-6).Within(1e-2 + 1e-3 * Math.Abs(run.Power[k])));
        }

        Assert.That(run.Record.Wings[0].Wing.Preset.Size.wingLength, Is.EqualTo(0.05f), "the published length");
        Assert.That(run.Record.Wings[2].Wing.Preset.Size.wingLength, Is.EqualTo(0.0485f));
        IReadOnlyList<WingDefinition> kinds = InsectCatalogue.Find("dragonfly").Wings;
        for (int kind = 0; kind < 2; kind++)
        {
            double ours = kinds[kind].Outline.Area * measured.Lengths[kind] * measured.Lengths[kind];
            Assert.That(run.Record.Wings[2 * kind].Wing.Preset.Size.fluidDensity / kinds[kind].CreatePreset().Size.fluidDensity,
                Is.EqualTo(measured.Areas[kind] / ours).Within(0.01).Percent, "forces go with the published area");
        }
    }
}
