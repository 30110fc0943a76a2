using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Each number of a flight's report beside the record: summary.json, the terminal's table, forces, joints and pictures.</summary>
public sealed class FlightReportLaws
{
    // By Pythagoras: 1.5² + 0.75².
    private const double k_Speed = 1.6770509831248424;

    private FlightRecord m_Flown;

    [OneTimeSetUp]
    public void Fly() => m_Flown = OddFlight.Fly();

    [Test]
    public void TheSummary_HasEachNumberOfTheRecord_InSixDigits()
    {
        FlightRecord flight = m_Flown;
        var summary = FlightSummary.Of(flight);
        using var stream = new MemoryStream();
        SummaryJson.Write(summary, stream);
        JsonElement json = JsonDocument.Parse(stream.ToArray()).RootElement;
        (float3 force, float3 moment) = Air(flight);
        double weight = flight.Wings[0].Wing.Preset.Size.insectMass * 9.81, pitch = OddFlight.Plan.PitchDegrees * Math.PI / 180;

        AssertWing(json, flight.Wings[0]);
        AssertWing(json.GetProperty("other_wings").EnumerateArray().Single(), flight.Wings[2]);
        AssertVector(json.GetProperty("mean_force_n"), force);
        AssertVector(json.GetProperty("mean_moment_n_m"), moment);
        AssertVector(json.GetProperty("induced_velocity_m_s"), flight.InducedVelocity);
        AssertNumber(json, "lift_over_weight", (Math.Cos(pitch) * force.y + Math.Sin(pitch) * force.z) / weight);
        AssertNumber(json, "newton_iterations_mean",
            flight.Wings.SelectMany(wing => wing.Frames).Average(frame => (double)frame.NewtonIterations));
        AssertNumber(json, "us_per_substep", flight.MicrosecondsPerSubstep);
        AssertNumber(json, "beats", flight.Seconds * flight.Wings[0].Frequency);
        AssertNumber(json, "seconds", flight.Seconds);
        Assert.That(json.GetProperty("triangles").GetInt32(),
            Is.EqualTo(InsectCatalogue.Find("fishfly").Wings.Sum(wing => 2 * wing.TriangleCount)));
        Assert.That(json.GetProperty("resets").GetInt32(), Is.EqualTo(flight.Wings.Sum(wing => wing.Resets)));
        Assert.That(flight.Seconds, Is.EqualTo(0.5).Within(1.0 / (20.0 * flight.Wings[0].Frequency)), "whole substeps");

        JsonElement options = json.GetProperty("options");
        foreach ((string key, double value) in new[]
        {
            ("speed_m_s", 1.5), ("climb_m_s", 0.75), ("pitch_deg", 20), ("induced_flow", 1.5), ("lag", 0.15), ("elasticity_factor", 2),
            ("substeps", 20), ("elements", 128),
        })
        {
            AssertNumber(options, key, value);
        }

        Assert.That(options.GetProperty("wind_m_s").EnumerateArray().Select(part => part.GetDouble()), Is.EqualTo(OddFlight.Plan.Wind));
        Assert.That(
            (options.GetProperty("coefficients").GetString(), options.GetProperty("preset").GetString(),
                options.GetProperty("variant").GetString()),
            Is.EqualTo(("flatplate", "physical", "expressive")));
        Assert.That((options.GetProperty("no_wave").GetBoolean(), options.GetProperty("rigid").GetBoolean(),
            options.GetProperty("added_mass").GetBoolean()), Is.EqualTo((false, false, true)));
        Assert.That(options.TryGetProperty("mesh", out _), Is.False);

        void AssertWing(JsonElement told, RecordedWing wing)
        {
            Assert.That(told.GetProperty("wing").GetString(), Is.EqualTo(wing.Wing.Name));
            foreach ((string key, _, double value, _) in Measures(wing))
                AssertNumber(told, key, value);
            AssertNumber(told, "leading_ei_n_m2", wing.Stiffness.Chains[0]);
            AssertNumber(told, "wing_ei_n_m2", wing.Stiffness.Chains.Sum());
            // Combes and Daniel 2003: EI over the span of 16 species.
            AssertNumber(told, "usual_ei_n_m2", Math.Pow(10, 0.08 + 2.97 * Math.Log10(wing.Wing.Preset.Size.wingLength)));
            var measured = WingSummary.Of(wing);
            Assert.That(told.GetProperty("outside_usual").EnumerateArray().Select(key => key.GetString()),
                Is.EqualTo(MeasureBound.All.Where(bound => !bound.Holds(measured, InsectVariant.Expressive)).Select(bound => bound.Key)));
        }
    }

    [Test]
    public void TheTerminal_ShowsEachNumberInItsRow_AndTheOneOfEachWingInItsColumn()
    {
        FlightRecord flight = m_Flown;
        var summary = FlightSummary.Of(flight);
        using var output = new StringWriter();
        new Terminal(output).ShowSummary(summary, "the folder", "a.txt", "b.txt");
        string[] lines = output.ToString().Split('\n');
        Dictionary<string, string[]> rows = Rows(lines);
        (float3 force, float3 moment) = Air(flight);
        double pitch = OddFlight.Plan.PitchDegrees * Math.PI / 180, weight = flight.Wings[0].Wing.Preset.Size.insectMass * 9.81;

        Assert.That(rows[""], Is.EqualTo(new[] { "", "fore wing", "hind wing", "usual" }));
        RecordedWing[] kinds = [flight.Wings[0], flight.Wings[2]];
        foreach ((string key, string title, _, string format) in Measures(kinds[0]).Where(measure => measure.Format != null))
        {
            var bound = MeasureBound.Find(key);
            for (int kind = 0; kind < 2; kind++)
            {
                string number = Measures(kinds[kind]).Single(measure => measure.Key == key).Value.ToString(format,
                    CultureInfo.InvariantCulture);
                Assert.That(rows[title][1 + kind], Is.EqualTo(bound?.Marked(number, WingSummary.Of(kinds[kind]),
                    InsectVariant.Expressive) ?? number), title);
            }

            Assert.That(rows[title][3], Is.EqualTo(bound?.RangeOf(InsectVariant.Expressive) ?? ""));
        }

        for (int kind = 0; kind < 2; kind++)
        {
            var wing = WingSummary.Of(kinds[kind]);
            Assert.That(rows["camber, % of the chord"][1 + kind], Does.StartWith(
                FormattableString.Invariant($"{wing.CamberMinPct:F1} … {wing.CamberMaxPct:F1}")));
            Assert.That(Number(rows["stiffness EI of the leading chain, N m²"][1 + kind]),
                Is.EqualTo(kinds[kind].Stiffness.Leading).Within(5).Percent);
            Assert.That(Number(rows["stiffness EI of all chains, N m²"][1 + kind]),
                Is.EqualTo(kinds[kind].Stiffness.Whole).Within(5).Percent);
        }

        Assert.That(Number(rows["stiffness EI of all chains, N m²"][3]), Is.EqualTo(kinds[0].Stiffness.Usual).Within(5).Percent);
        Assert.That(Numbers("mean force right, up, ahead of the body, mN"),
            Is.EqualTo(new[] { 1e3 * force.x, 1e3 * force.y, 1e3 * force.z }).Within(0.0051));
        Assert.That(Numbers("mean moment nose down, nose right, right wing up, µN m"),
            Is.EqualTo(new[] { 1e6 * moment.x, 1e6 * moment.y, 1e6 * moment.z }).Within(0.0051));
        Assert.That(Number(rows["lift over weight"][1]),
            Is.EqualTo((Math.Cos(pitch) * force.y + Math.Sin(pitch) * force.z) / weight).Within(0.0051));
        Assert.That(Number(rows["Newton iterations, mean"][1]), Is.EqualTo(summary.NewtonIterationsMean).Within(0.0051));
        Assert.That(rows["resets"][1], Is.EqualTo($"{summary.Resets}"));
        Assert.That(Number(rows["µs per substep, all wings"][1]), Is.EqualTo(flight.MicrosecondsPerSubstep).Within(0.051));
        Assert.That(rows["lift over weight"][2..], Is.EqualTo(new[] { "", "" }), "of all wings, so in the first column");

        float3 drawn = flight.InducedVelocity;
        Assert.That(lines, Has.Some.EqualTo(FormattableString.Invariant(
            $"{flight.Seconds * flight.Wings[0].Frequency:0.##} beats in {flight.Seconds:0.###} s at {k_Speed:0.##} m/s; ")
            + $"{summary.Triangles} triangles."));
        Assert.That(lines, Has.Some.EqualTo(FormattableString.Invariant(
            $"The wings draw air along at {math.length(drawn):0.###} m/s: {-drawn.y:0.###} down, {-drawn.z:0.###} back.")));
        Assert.That(string.Join('\n', lines), Does.Contain("The last beat:").And.Contain(MeasureBound.Note).And.Contain(
            $"Written:\n  {Path.Combine("the folder", "a.txt")}\n  {Path.Combine("the folder", "b.txt")}\n"));
        foreach (MeasureBound bound in MeasureBound.All)
        {
            bool isOutside = kinds.Any(wing => !bound.Holds(WingSummary.Of(wing), InsectVariant.Expressive));
            string told = $"† {bound.Title} is outside the usual {bound.RangeOf(InsectVariant.Expressive)} ({bound.Source}).";
            Assert.That(lines.Contains(told), Is.EqualTo(isOutside), told);
        }

        double[] Numbers(string row) => [.. rows[row][1].Split(',').Select(Number)];
    }

    [Test]
    public void NamesOfFiles_AreNotBroken_HoweverLongTheyAre()
    {
        using var output = new StringWriter();
        string folder = new('x', 200);
        new Terminal(output).ShowFiles(folder, "a.txt", "b.txt");

        Assert.That(output.ToString().ReplaceLineEndings("\n"),
            Is.EqualTo($"Written:\n  {Path.Combine(folder, "a.txt")}\n  {Path.Combine(folder, "b.txt")}\n"));
    }

    [Test]
    public void Forces_AreThoseOfAllWings_LiftUp_DragAgainstTheWay()
    {
        FlightRecord flight = m_Flown;
        IReadOnlyList<string>[] rows = [.. ForceTable.Of(flight)];
        double pitch = OddFlight.Plan.PitchDegrees * Math.PI / 180;
        // On the body: nose up by the pitch, up leans to the front, ahead looks down.
        double[] up = [0, Math.Cos(pitch), Math.Sin(pitch)], ahead = [0, -Math.Sin(pitch), Math.Cos(pitch)];
        double[] way = [0, .75 * up[1] + 1.5 * ahead[1], .75 * up[2] + 1.5 * ahead[2]];
        Assert.That(rows, Has.Length.EqualTo(1 + flight.Wings[0].Frames.Count));
        for (int k = 0; k < rows.Length - 1; k++)
        {
            (float3 force, float3 moment) = Air(flight, k);
            var told = rows[0].Zip(rows[k + 1]).ToDictionary(cell => cell.First, cell => cell.Second);
            foreach ((string column, double value) in new[]
            {
                ("time_s", flight.Wings[0].Frames[k].Time), ("phase_deg", 180 / Math.PI * flight.Wings[0].Frames[k].Phase),
                ("force_x_n", force.x), ("force_y_n", force.y), ("force_z_n", force.z),
                ("moment_x_nm", moment.x), ("moment_y_nm", moment.y), ("moment_z_nm", moment.z),
                ("lift_n", up[1] * force.y + up[2] * force.z), ("drag_n", -(way[1] * force.y + way[2] * force.z) / k_Speed),
            })
            {
                Assert.That(Number(told[column]), Is.EqualTo(value).Within(1e-4 * Math.Abs(value) + 1e-9), column);
            }

            Assert.That(told["half_stroke"], Is.EqualTo(flight.Wings[0].Frames[k].Phase < Math.PI ? "down" : "up"));
        }
    }

    [Test]
    public void Joints_StandInMetresOnTheBody_AndTheirBendsInDegrees()
    {
        FlightRecord flight = m_Flown;
        string[][] rows = [.. JointTable.Of(flight).Skip(1).Select(row => row.ToArray())];
        int at = 0;
        foreach (RecordedWing wing in flight.Wings)
        {
            foreach (RecordedFrame frame in wing.Frames)
            {
                for (int k = 0; k < frame.Joints.Length; k++, at++)
                {
                    int chain = k / wing.JointsPerChain, joint = k % wing.JointsPerChain;
                    float3 place = wing.Placement.Hinge + wing.Placement.Length * frame.Joints[k];
                    if (wing.Placement.IsLeft)
                        place.x = -place.x;
                    double[] numbers = [.. rows[at].Where((cell, column) => column is 0 or 1 or >= 6 && cell.Length > 0).Select(Number)];
                    Assert.That(rows[at][2..6], Is.EqualTo(new[] { wing.Wing.Name, wing.Placement.IsLeft ? "left" : "right", $"{chain}",
                        $"{joint}" }));
                    List<double> expected = [frame.Time, 180 / Math.PI * frame.Phase, place.x, place.y, place.z];
                    if (joint < wing.JointsPerChain - 1)
                    {
                        float3 bend = frame.Bends[chain * (wing.JointsPerChain - 1) + joint];
                        expected.AddRange([180 / Math.PI * bend.x, 180 / Math.PI * bend.y, 180 / Math.PI * bend.z]);
                    }

                    if (numbers.Length != expected.Count || numbers.Zip(expected).Any(pair => Math.Abs(pair.First - pair.Second) > 6e-5))
                        Assert.Fail($"{string.Join(',', rows[at])}, not {string.Join(',', expected)}");
                }
            }
        }

        Assert.That(rows, Has.Length.EqualTo(at));
    }

    // Cells by the first of their row; a row without numbers goes on with the one before.
    private static Dictionary<string, string[]> Rows(string[] lines)
    {
        var rows = new List<string[]>();
        foreach (string line in lines.Where(line => line.StartsWith('│')))
        {
            string[] cells = [.. line.Trim('│').Split('│').Select(cell => cell.Trim())];
            if (rows.Count > 1 && (cells[0].Length == 0 || cells.Skip(1).All(cell => cell.Length == 0)))
                rows[^1] = [.. rows[^1].Zip(cells, (one, more) => $"{one} {more}".Trim())];
            else
                rows.Add(cells);
        }

        return rows.ToDictionary(cells => cells[0]);
    }

    // Key, title of the terminal's row, value, format there.
    private static IEnumerable<(string Key, string Title, double Value, string Format)> Measures(RecordedWing wing)
    {
        WingDeformation beat = wing.Measurement.Measure(wing.Beat);
        const double k_Degree = Math.PI / 180;
        return
        [
            ("frequency_hz", "frequency, Hz", (wing.Frames.Count - 1) / (wing.Frames.Count * (wing.Frames[^1].Time - wing.Frames[0].Time)),
                "F2"),
            ("twist_pp_deg", "twist, peak to peak, °", beat.TwistRange / k_Degree, "F1"),
                ("camber_min_pct", null, 100.0 * beat.CamberMin, null),
            ("camber_max_pct", null, 100.0 * beat.CamberMax, null),
                ("tip_bend_pp_deg", "tip bend, peak to peak, °", beat.TipBendRange / k_Degree, "F1"),
            ("tip_bend_max_deg", "tip bend, largest, °", beat.TipBendMax / k_Degree, "F1"),
            ("lag_deg", "lag of the trailing edge, °", beat.Lag / k_Degree, "F1"),
                ("tip_lag_deg", "lag of the tip, °", beat.TipLag / k_Degree, "F1"),
            ("edge_stretch_max_pct", "edge stretch, largest, %", 100.0 * beat.StretchMax, "F2"),
            ("edge_stretch_p99_pct", "edge stretch, 99th percentile, %", 100.0 * beat.Stretch99, "F2"),
        ];
    }

    // Newton and newton metres on the body, of a frame or in the mean: a left wing's forces are mirrored in x, its moments in y and z.
    private static (float3 Force, float3 Moment) Air(FlightRecord flight, int? only = null)
    {
        float3 force = 0f, moment = 0f;
        foreach (RecordedWing wing in flight.Wings)
        {
            float mass = wing.Wing.Preset.Size.wingMass, length = wing.Wing.Preset.Size.wingLength, side = wing.Placement.IsLeft ? -1f : 1f;
            foreach (RecordedFrame frame in only is int k ? [wing.Frames[k]] : wing.Frames)
            {
                float share = only == null ? 1f / wing.Frames.Count : 1f;
                force += share * mass * length * frame.AirForce * new float3(side, 1f, 1f);
                moment += share * mass * length * length * frame.AirMoment * new float3(1f, side, side);
            }
        }

        return (force, moment);
    }

    private static void AssertNumber(JsonElement json, string key, double value) =>
        Assert.That(json.GetProperty(key).GetDouble(), Is.EqualTo(value).Within(2e-5 * Math.Abs(value) + 1e-12), key);

    private static void AssertVector(JsonElement json, float3 value)
    {
        double[] told = [.. json.EnumerateArray().Select(part => part.GetDouble())];
        for (int k = 0; k < 3; k++)
            Assert.That(told[k], Is.EqualTo(value[k]).Within(1e-4 * math.length(value) + 1e-12));
    }

    private static double Number(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
}
