using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Columns of the tables that studies write have the units of their names.</summary>
public sealed class TableUnitLaws
{
    [Test]
    public void MeasuresOfAWing_AreInHertzDegreesAndPerCent()
    {
        RecordedWing wing = MonarchFlight.Level.Wings[0];
        WingDeformation beat = wing.Measurement.Measure(wing.Beat);
        var summary = WingSummary.Of(wing);
        double Measure(string key) => WingMeasure.All.Single(measure => measure.Key == key).Of(summary);

        Assert.That(Measure("frequency_hz"), Is.EqualTo(Frequency(wing)).Within(0.1).Percent);
        foreach ((string key, double radians) in new[]
        {
            ("twist_pp_deg", beat.TwistRange), ("tip_bend_pp_deg", beat.TipBendRange), ("tip_bend_max_deg", beat.TipBendMax),
            ("lag_deg", beat.Lag),
            ("tip_lag_deg", (double)beat.TipLag),
        })
        {
            Assert.That(Measure(key), Is.EqualTo(180.0 / Math.PI * radians).Within(1e-4), key);
        }

        foreach ((string key, double share) in new[]
        {
            ("camber_min_pct", beat.CamberMin), ("camber_max_pct", beat.CamberMax), ("edge_stretch_p99_pct", beat.Stretch99),
            ("edge_stretch_max_pct", Stretch(wing)),
        })
        {
            Assert.That(Measure(key), Is.EqualTo(100.0 * share).Within(1e-4), key);
        }

        Assert.That(WingMeasure.All.Select(measure => measure.Of(summary)).Distinct().Count(), Is.EqualTo(WingMeasure.All.Count),
            "each its own");
    }

    [Test]
    public void RowsOfWind_HaveEachNumberUnderItsName()
    {
        WindDirection side = WindDirection.All[3];
        WindPoint now = new(1.5, 11.25, 7.5, side, -3.75, 2), before = new(1.5, 22.5, 8.25, null, 4.5, 9);
        var species = new SpeciesWinds(new FlightPlan { Species = "monarch" }, "Monarch", 1.0, [new WingWinds("wing", [now], [before])]);
        List<Dictionary<string, string>> rows = Rows(stream => WindTable.Write([species], true, stream));

        foreach ((WindPoint point, string model, Dictionary<string, string> row) in
            new[] { (now, "now", rows[0]), (before, "0.1", rows[1]) })
        {
            Assert.That((row["species"], row["wing"], row["model"], row["air"]), Is.EqualTo(("monarch", "wing", model, "gusts")));
            Assert.That((Number(row, "wind_m_s"), Number(row, "edge_stretch_max_pct"), Number(row, "edge_stretch_p99_pct")),
                Is.EqualTo((point.Speed, point.StretchMaxPct, point.StretchP99Pct)));
            Assert.That((row["worst_from"], Number(row, "head_wind_tip_bend_max_deg"), Number(row, "resets")),
                Is.EqualTo((point.Worst?.Name ?? "", point.HeadBendDeg, (double)point.Resets)));
        }
    }

    // In still air both are the wing on the spot.
    [Test]
    public void StillAirInTheTunnel_StretchesAWing_AsItsFlightDoes()
    {
        var plan = new FlightPlan { Species = "monarch" };
        using var tunnel = new WindTunnel(plan, Insect.Of(plan).Wings[0]);
        WindPoint still = tunnel.Measure(0.0, false);
        var flown = WingSummary.Of(MonarchFlight.Level.Wings[0]);

        Assert.That(still.StretchMaxPct, Is.EqualTo(flown.EdgeStretchMaxPct).Within(2).Percent);
        Assert.That(still.StretchP99Pct, Is.EqualTo(flown.EdgeStretchP99Pct).Within(2).Percent);
        Assert.That(still.HeadBendDeg, Is.EqualTo(flown.TipBendMaxDeg).Within(2).Percent);
    }

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void RowsOfASweep_AreThoseOfFlightsWithItsValues()
    {
        var flight = new FlightPlan { Species = "monarch", Substeps = 12 };
        var plan = new SweepPlan(FlownParameters.Find("pitch"), 0.0, 40.0, 9, flight, SweepWaves.On);
        var sweep = Sweep.Fly(plan, _ => { });
        List<Dictionary<string, string>> rows = Rows(stream => SweepTable.Write(sweep, stream));

        Assert.That(rows.Select(row => Number(row, "pitch")), Is.EqualTo(Enumerable.Range(0, 9).Select(k => 5.0 * k)));
        FlightRecord own = TetheredFlight.Fly(flight with { PitchDegrees = 30.0 }),
            driven = TetheredFlight.Fly(flight with { PitchDegrees = 30.0, HoldJoints = true });
        Dictionary<string, string> told = rows[6];
        Assert.That(Number(told, "edge_stretch_max_pct"), Is.EqualTo(100.0 * Stretch(own.Wings[0])).Within(2e-3));
        Assert.That(Number(told, "frequency_hz"), Is.EqualTo(Frequency(own.Wings[0])).Within(0.1).Percent);
        Assert.That(Number(told, "lift_over_weight"), Is.EqualTo(Lift(own, 30.0)).Within(1e-3));
        Assert.That(Number(told, "camber_load_pp_pct"),
            Is.EqualTo(100.0 * own.Wings[0].Measurement.CamberBeyond(own.Wings[0].Beat, driven.Wings[0].Beat)).Within(1e-3));

        using var folder = new TemporaryFolder();
        string path = folder.PathOf("sweep.png");
        File.WriteAllBytes(path, SweepPicture.DrawPoses(sweep));
        double[] shown = PngTexts.Of(path).Where(text => double.TryParse(text, CultureInfo.InvariantCulture, out _))
            .Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();
        Assert.That(shown, Has.Length.EqualTo(8), "columns of a picture, of more values the evenly chosen ones");
        Assert.That(shown, Is.Ordered.Ascending.And.SubsetOf(plan.Values));
        Assert.That((shown[0], shown[^1]), Is.EqualTo((0.0, 40.0)), "both ends");
        Assert.That(shown.Zip(shown.Skip(1), (a, b) => b - a), Is.All.InRange(5.0, 10.0));
    }

    [Test]
    public void RowsOfAComparison_AreThoseOfItsFlights()
    {
        var flight = new FlightPlan { Species = "monarch", Substeps = 24, PitchDegrees = 20.0 };
        List<Comparison> flown = Comparison.Fly(new ComparisonPlan([flight], [ComparisonColumn.RigidWing, ComparisonColumn.FullModel], 1),
            _ => { });
        List<Dictionary<string, string>> rows = Rows(stream => ComparisonTable.Write(flown, stream));
        FlightRecord rigid = TetheredFlight.Fly(flight with { Column = ComparisonColumn.RigidWing }), full = TetheredFlight.Fly(flight);
        double sum = 0.0, most = 0.0;
        for (int phase = 0; phase < 24; phase++)
        {
            float3[] places = rigid.Wings[0].At(phase / 24.0).Positions, others = full.Wings[0].At(phase / 24.0).Positions;
            double[] off = places.Zip(others, (a, b) => 100.0 * math.distance(a, b) / rigid.Wings[0].Wing.Preset.Size.wingLength).ToArray();
            sum += off.Average() / 24.0;
            most = Math.Max(most, off.Max());
        }

        Assert.That(rows.Select(row => row["column"]),
            Is.EqualTo(new[] { ComparisonColumn.RigidWing.Name, ComparisonColumn.FullModel.Name }));
        Assert.That(Number(rows[0], "distance_from_full_mean_pct"), Is.EqualTo(sum).Within(1).Percent.And.GreaterThan(1.0));
        Assert.That(Number(rows[0], "distance_from_full_max_pct"), Is.EqualTo(most).Within(1).Percent);
        Assert.That((Number(rows[1], "distance_from_full_mean_pct"), Number(rows[1], "distance_from_full_max_pct")),
            Is.EqualTo((0.0, 0.0)));
        foreach ((Dictionary<string, string> row, FlightRecord record) in new[] { (rows[0], rigid), (rows[1], full) })
        {
            Assert.That(Number(row, "lift_over_weight"), Is.EqualTo(Lift(record, 20.0)).Within(1e-3));
            Assert.That(Number(row, "edge_stretch_max_pct"), Is.EqualTo(100.0 * Stretch(record.Wings[0])).Within(2e-3));
        }
    }

    [Test]
    public void RowsOfABake_TellItsErrorsInPerCentAndDegrees()
    {
        InsectBake bake = new BakePlan { Species = InsectCatalogue.Find("fishfly"), Frames = 8 }.Bake(out _);
        BakedClip clip = bake.Clips[0];
        clip.Error = new BakeError { between = 0.0125f, normalBetween = 3.5f, closure = 0.0275f, linearSkin = 0.015f };
        string[][] table = BakeReport.Rows(bake).Select(row => row.ToArray()).ToArray();
        double Told(string column) => double.Parse(table[1][Array.IndexOf(table[0], column)], CultureInfo.InvariantCulture);

        Assert.That((Told("frames"), Told("loop Hz")), Is.EqualTo((8.0, Math.Round(clip.Frequency, 2))));
        Assert.That((Told("between frames %"), Told("loop end %"), Told("linear skin %")), Is.EqualTo((1.25, 2.75, 1.5)));
        Assert.That(Told("normals °"), Is.EqualTo(3.5));
    }

    // Over the beat, from the frames' own times.
    private static double Frequency(RecordedWing wing) =>
        (wing.Frames.Count - 1.0) / wing.Frames.Count / (wing.Frames[^1].Time - wing.Frames[0].Time);

    private static double Stretch(RecordedWing wing)
    {
        double most = 0.0;
        for (int k = 0; k < wing.Triangles.Length; k++)
        {
            int a = wing.Triangles[k], b = wing.Triangles[k % 3 == 2 ? k - 2 : k + 1];
            foreach (RecordedFrame frame in wing.Frames)
            {
                double length = math.distance(frame.Positions[a], frame.Positions[b]), rest = math.distance(wing.Rest[a], wing.Rest[b]);
                most = Math.Max(most, Math.Abs(length / rest - 1.0));
            }
        }

        return most;
    }

    // Left wings mirror right ones, so that only the force in the plane of symmetry is left; the body's up leans back with its pitch.
    private static double Lift(FlightRecord flight, double pitch)
    {
        double sum = 0.0, radians = Math.PI / 180.0 * pitch;
        foreach (RecordedWing wing in flight.Wings)
        {
            PresetSize size = wing.Wing.Preset.Size;
            sum += wing.Frames.Average(frame => size.wingMass * size.wingLength
                * (Math.Cos(radians) * frame.AirForce.y + Math.Sin(radians) * frame.AirForce.z));
        }

        return sum / (9.81 * flight.Wings[0].Wing.Preset.Size.insectMass);
    }

    private static double Number(Dictionary<string, string> row, string column) => double.Parse(row[column], CultureInfo.InvariantCulture);

    private static List<Dictionary<string, string>> Rows(Action<Stream> write)
    {
        using var stream = new MemoryStream();
        write(stream);
        string[][] lines = Encoding.UTF8.GetString(stream.ToArray()).TrimStart('\uFEFF').TrimEnd().Split('\n')
            .Select(line => line.Trim().Split(',')).ToArray();
        return lines.Skip(1).Select(line => line
            .Select((cell, k) => (lines[0][k], cell)).ToDictionary(pair => pair.Item1, pair => pair.cell)).ToList();
    }
}
