using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Tables of studies: each made-up number stands under its heading, in its unit and digits.</summary>
public sealed class StudyTableLaws
{
    private static readonly WingConvergence s_Wing = new("fore wing",
        [
            new(TimeScheme.SecondOrder, 12, 0.91234, 0.6), new(TimeScheme.BackwardEuler, 12, 5.5, 0.51),
                new(TimeScheme.SecondOrder, 24, 0.2, 1.25),
            new(TimeScheme.BackwardEuler, 24, 3.25, 1.125),
        ],
        new(TimeScheme.SecondOrder, 24, 0.2, 1.25), new(TimeScheme.BackwardEuler, 48, 2.5, 1.0),
        [
            new("twist_pp_deg", "twist", 22.0, 20.0), new("camber_min_pct", "least camber", -1.5, -2.0),
                new("lift_over_weight", "lift", 0.5, 0.5),
        ]);

    private static readonly WingWinds s_Winds = new("fin",
        [
            new(0, 2.25, 1.5, null, 10.25, 0), new(0.3, 3.5, 2.5, WindDirection.All[0], 11.25, 1),
                new(0.5, 4.5, 3.5, WindDirection.All[1], 12.25, 2),
            new(1, 6.5, 5.5, WindDirection.All[25], 13.25, 3),
        ],
        [new(0, 7, 6, null, 1, 0), new(0.3, 88, 44, WindDirection.All[2], 2, 0), new(0.5, 9, 8, WindDirection.All[2], 3, 0),
            new(1, 10, 9, WindDirection.All[2], 4, 5)]);

    [Test]
    public void RowsOfConvergence_HaveErrorsAndCosts_AndMarkTheDefaults()
    {
        string[][] errors = [.. ConvergenceTable.Errors(s_Wing).Select(row => row.ToArray())],
            values = [.. ConvergenceTable.Values(s_Wing).Select(row => row.ToArray())];

        Assert.That(errors, Is.EqualTo(new[]
        {
            new[] { "substeps", "second order: error, %", "cost", "backward Euler: error, %", "cost" },
                ["12", "0.912", "0.60", "5.500", "0.51"],
            ["24 (default)", "0.200", "1.25", "3.250", "1.13"], ["version 0.1, 48", "", "", "2.500", "1.00"],
        }).Or.EqualTo(new[]
        {
            new[] { "substeps", "second order: error, %", "cost", "backward Euler: error, %", "cost" },
                ["12", "0.912", "0.60", "5.500", "0.51"],
            ["24 (default)", "0.200", "1.25", "3.250", "1.12"], ["version 0.1, 48", "", "", "2.500", "1.00"],
        }), "a half is rounded either way");
        Assert.That(values, Is.EqualTo(new[]
        {
            new[] { "", "at 24 substeps", "at 480", "difference, %" }, ["twist", "22.00", "20.00", "+10.0"],
                ["least camber", "−1.50", "−2.00", "+25.0"],
            ["lift", "0.50", "0.50", "0.0"],
        }));

        using var stream = new MemoryStream();
        ConvergenceTable.Write([new SpeciesConvergence(new FlightPlan { Species = "firefly" }, "Firefly", [s_Wing])], stream);
        string[] lines = System.Text.Encoding.UTF8.GetString(stream.ToArray()).Trim().Split('\n');
        Assert.That(lines[1..], Is.EqualTo(new[]
        {
            "firefly,standard,fore wing,now,second-order,12,0.91234,0.6,no", "firefly,standard,fore wing,now,backward-euler,12,5.5,0.51,no",
            "firefly,standard,fore wing,now,second-order,24,0.2,1.25,yes", "firefly,standard,fore wing,now,backward-euler,24,3.25,1.125,no",
            "firefly,standard,fore wing,0.1,backward-euler,48,2.5,1,yes",
        }));
        Assert.That((s_Wing.By(TimeScheme.SecondOrder).Count, s_Wing.By(TimeScheme.BackwardEuler)[1].ErrorPct), Is.EqualTo((2, 3.25)));
    }

    [Test]
    public void TablesOfThePage_HaveTheDefaults_TheLimits_AndTheWindsOfTheSpecies()
    {
        var species = new SpeciesConvergence(new FlightPlan { Species = "firefly" }, "Firefly", [s_Wing]);
        var winds = new SpeciesWinds(new FlightPlan { Species = "snailfish" }, "Snailfish", 0.1, [s_Winds]);

        Assert.That(AccuracyTable.Errors([species]).Last(), Is.EqualTo(new[] { "firefly", "fore wing", "24", "0.200", "2.500", "1.25" }));
        Assert.That(AccuracyTable.Values([species]).Last(), Is.EqualTo(new[]
        {
            "firefly", "fore wing", "22.0 / 20.0 (+10.0 %)", "−1.50 / −2.00 (+25.0 %)", "", "", "", "0.50 / 0.50 (+0.0 %)",
        }));
        string[][] rows = [.. AccuracyTable.Winds([winds]).Select(row => row.ToArray())];
        Assert.That(rows[0][2..6], Is.EqualTo(new[] { "still", "3 m/s", "5 m/s", "10 m/s" }));
        Assert.That(rows[1].Select(cell => cell.Replace("2.3 /", "2.2 /").Replace("10.3", "10.2").Replace("11.3", "11.2").Replace("13.3",
            "13.2")),
            Is.EqualTo(new[]
            {
                "snailfish", "fin", "2.2 / 1.5", "3.5 / 2.5", "4.5 / 3.5", "6.5 / 5.5", WindDirection.All[25].Name, "88",
                    "10.2, 11.2, 13.2",
            }), "a tenth of the speeds in water");
        string[][] told = [.. WindTable.Of(s_Winds).Select(row => row.ToArray())];
        Assert.That(told[2], Is.EqualTo(new[] { "0.3", "3.5", "2.5", WindDirection.All[0].Name, told[2][4], "88.0", "44.0" }));
        Assert.That(double.Parse(told[2][4], CultureInfo.InvariantCulture), Is.EqualTo(11.25).Within(0.051));
        Assert.That(told[1][3], Is.Empty);
    }

    [Test]
    public void ThePageOfAccuracy_GetsItsThreeTables_AndTwoPictures()
    {
        SpeciesConvergence[] errors = [new SpeciesConvergence(new FlightPlan { Species = "firefly" }, "Firefly", [s_Wing])];
        SpeciesWinds[] winds = [new SpeciesWinds(new FlightPlan { Species = "snailfish" }, "Snailfish", 0.1, [s_Winds])];
        string Page(string one, string two, string three) => "a\n" + PageBlock.Begin("errors") + one + PageBlock.End("errors") + "\nb\n"
            + PageBlock.Begin("converged values") + two + PageBlock.End("converged values") + PageBlock.Begin("winds") + three
            + PageBlock.End("winds");
        (string Name, string Text)[] files = [.. AccuracyFigures.Make(Page("x\n", "y\n", "z\n"), errors, winds)];

        Assert.That(files.Select(file => file.Name), Is.EqualTo(AccuracyFigures.Files));
        Assert.That(files[0].Text, Is.EqualTo(Page(MarkdownTable.Write(AccuracyTable.Errors(errors)),
            MarkdownTable.Write(AccuracyTable.Values(errors)), MarkdownTable.Write(AccuracyTable.Winds(winds)))));
        Assert.That(files[1].Text, Is.EqualTo(ConvergencePicture.Draw(errors)));
        Assert.That(files[2].Text, Is.EqualTo(WindPicture.Draw(winds, false)));
    }

    [Test]
    public void RowsOfATrim_HaveEachNumberUnderItsName_AndNoneWhereItDoesNotClose()
    {
        var row = new TrimRow(1.25, -0.5, true, 1.125, 2.25, 3.5, 4.5, 0.875, 5.5, 6.5, 7.5, 0.00125, 0.0025, 0.00375, null);
        var told = TrimRow.Header.Zip(row.Cells()).ToDictionary(cell => cell.First, cell => cell.Second);
        foreach ((string column, string value) in new[]
        {
            ("speed_m_s", "1.25"), ("climb_m_s", "-0.5"), ("closes", "yes"), ("pitch_deg", "1.125"), ("pitch_bob_deg", "2.25"),
                ("frequency_hz", "3.5"),
            ("flap_deg", "4.5"), ("amplitude", "0.875"), ("tilt_deg", "5.5"), ("mean_sweep_deg", "6.5"), ("power_mw", "7.5"),
            ("lift_residual", "0.00125"), ("thrust_residual", "0.0025"), ("moment_residual", "0.00375"), ("problem", ""),
        })
        {
            Assert.That(told[column], Is.EqualTo(value), column);
        }

        Assert.That(TrimRow.Header, Has.Length.EqualTo(15));

        string[] open = (row with { Closes = false, Pitch = double.NaN, Problem = "lift is missing" }).Cells();
        Assert.That((open[2], open[3], open[^1]), Is.EqualTo(("no", "", "lift is missing")));
    }

    // What trims in radians and shares becomes degrees, hertz and milliwatts.
    [Test]
    public void ASurvey_TellsItsTrims_InDegreesHertzAndMilliwatts()
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        TrimRow row = TrimSurvey.Make(model, [1.3f], [0f], null, _ => { }).Single();
        using var solver = new TrimSolver(model);
        using var grid = new TrimTable([1.3f], [0f]);
        TrimState trim = new TrimBake(model).Trims(solver, grid)[0, 0];
        double[] residual = solver.Residual(trim, new FlightCondition(1.3f, 0f), out double power);
        const double k_Degree = Math.PI / 180;

        foreach ((double told, double expected) in new[]
        {
            (row.Speed, 1.3), (row.Climb, 0.0), (row.Pitch, trim.Pitch / k_Degree), (row.PitchBob, trim.PitchBob / k_Degree),
            (row.Frequency, trim.FrequencyScale * model.Frequency), (row.Amplitude, trim.AmplitudeScale), (row.Tilt, trim.Tilt / k_Degree),
            (row.Flap, 2 / k_Degree * model.Wings[0].Parameters.amplitude.x * trim.AmplitudeScale), (row.Sweep, trim.MeanSweep / k_Degree),
            (row.Power, 1000 * power), (row.Lift, residual[0]), (row.Thrust, residual[1]), (row.Moment, residual[2]),
        })
        {
            Assert.That(told, Is.EqualTo(expected).Within(1e-3 * Math.Abs(expected) + 1e-5));
        }

        Assert.That((row.Closes, row.Problem), Is.EqualTo((true, (string)null)));
        Assert.That(row.Power, Is.InRange(1.0, 20.0), "milliwatts");
        Assert.That(row.Flap, Is.InRange(60.0, 180.0), "degrees from end to end");
    }

    private static IEnumerable<InsectDefinition> Flyers => InsectCatalogue.All.Where(insect => File.Exists(TrimSource.PathOf(insect)));

    // The source that was written holds the text, and gives the file as it lies there.
    [TestCaseSource(nameof(Flyers))]
    public void TheSourceOfATable_IsWrittenAsItLiesThere(InsectDefinition insect)
    {
        string source = File.ReadAllText(TrimSource.PathOf(insect)).ReplaceLineEndings("\n");
        string text = string.Concat(Regex.Matches(source, "^ +\"([^\"]*)\"( \\+|;)$",
            RegexOptions.Multiline).Select(line => line.Groups[1].Value));
        string options = Regex.Match(source, @"--bake(.*)\.(</summary>)?$", RegexOptions.Multiline).Groups[1].Value;

        Assert.That(text, Has.Length.GreaterThan(500));
        Assert.That(TrimSource.Write(insect, text, options), Is.EqualTo(source));
    }

    [Test]
    public void FreeFlights_StandBesideTheOneOnTheSpot_NumberByNumber()
    {
        var plan = new ComparisonPlan([new FlightPlan { Species = "monarch", Speed = 1.3, PitchDegrees = 12, Substeps = 12 }],
            [ComparisonColumn.FullModel], 1);
        var counted = new List<int>();
        Comparison flown = Comparison.Fly(plan, counted.Add).Single();
        Assert.That(counted, Is.EqualTo(Enumerable.Range(1, plan.Columns.Count)), "flights that are done");
        string[][] rows = [.. FreeComparisonTable.Lines(flown).Select(row => row.ToArray())];
        FlightMeans free = flown.Free;
        RecordedWing wing = flown.Held.Summary.Flight.Wings[0];

        Assert.That(rows[0], Is.EqualTo(new[] { "", "on the spot", "free flight" }));
        var told = rows.Skip(1).ToDictionary(row => row[0]);
        foreach ((string name, double? held, double now) in new (string, double?, double)[]
        {
            ("speed_m_s", 1.3, free.Speed), ("climb_m_s", 0, free.Climb), ("velocity_error_m_s", null, free.Error),
                ("frequency_hz", wing.Frequency, free.Frequency),
            ("flap_deg", null, free.Flap), ("pitch_deg", 12, free.Pitch), ("pitch_bob_deg", 0, free.PitchBob),
                ("height_bob_mm", 0, free.HeightBob),
            ("lift_over_weight", flown.Held.Summary.LiftOverWeight, free.Lift), ("downstroke_lift_over_weight", null, free.DownLift),
            ("upstroke_support_share", null, free.UpSupport), ("upstroke_force_share", null, free.UpForce), ("power_w", null, free.Power),
            ("power_per_mass_w_kg", null, free.PowerPerMass),
        })
        {
            double? spot = told[name][1].Length == 0 ? null : double.Parse(told[name][1], CultureInfo.InvariantCulture);
            Assert.That(spot, held == null ? Is.Null : Is.EqualTo(held).Within(1e-4), name);
            Assert.That(double.Parse(told[name][2], CultureInfo.InvariantCulture), Is.EqualTo(now).Within(1e-5), name);
        }

        Assert.That(told["variant"][1..], Is.EqualTo(new[] { "standard", "flight" }));
        Assert.That(free.Speed, Is.EqualTo(1.3).Within(0.1));
        Assert.That(free.Pitch, Is.InRange(5.0, 60.0), "degrees");
        Assert.That(free.PowerPerMass * flown.Held.Summary.Flight.Wings[0].Wing.Preset.Size.insectMass,
            Is.EqualTo(free.Power).Within(30).Percent);
    }

    [Test]
    public void AFreeFlight_IsAtMostAsFastAsTheInsectFlies()
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using FlightModel model = CatalogueFlight.CreateModel(monarch);
        using TrimTable table = CatalogueFlight.CreateTable(monarch, model);
        var plan = new FlightPlan { Species = "monarch", Speed = 2 * table.TopSpeed, Substeps = 12, Patches = 64 };
        Comparison flown = Comparison.Fly(new ComparisonPlan([plan], [ComparisonColumn.FullModel], 1), _ => { }).Single();

        Assert.That(flown.Free.Speed, Is.EqualTo(table.TopSpeed).Within(5).Percent);
        Assert.That(flown.Free.Error, Is.LessThan(0.1 * table.TopSpeed), "it follows what it is told");
    }

    [TestCase(10.0, 0.0, false, new[] { 10.0, 5.0, 0.0 })]
    [TestCase(0.0, 10.0, false, new[] { 0.0, 5.0, 10.0 })]
    [TestCase(-1.0, -21.0, false, new[] { -1.0, -11.0, -21.0 })]
    [TestCase(1.0, 9.0, false, new[] { 1.0, 5.0, 9.0 })]
    [TestCase(1.0, 16.0, true, new[] { 1.0, 4.0, 16.0 })]
    [TestCase(16.0, 1.0, true, new[] { 16.0, 4.0, 1.0 })]
    [TestCase(0.1, 0.4, false, new[] { 0.1, 0.25, 0.4 })]
    [TestCase(1.0, 10.0, true, new[] { 1.0, 3.16228, 10.0 })]
    public void ValuesOfASweep_HaveEqualRatios_WhereTheySpanAFactorOfTenAboveNought(double from, double to, bool isLogarithmic,
        double[] values)
    {
        var plan = new SweepPlan(FlownParameters.Find("climb"), from, to, 3, new FlightPlan { Species = "monarch" }, SweepWaves.On);

        Assert.That(plan.IsLogarithmic, Is.EqualTo(isLogarithmic));
        Assert.That(plan.Values, Is.EqualTo(values), "six digits");
    }

    // Amplitude and lag of a motion are told in per cent and in degrees behind.
    [TestCase(0.5, -30.0, 50.0, 30.0)]
    [TestCase(2.0, 90.0, 200.0, 270.0)]
    public void MotionsOfAStrip_AreInPerCent_AndDegreesBehind(double size, double degrees, double percent, double behind)
    {
        var beam = Complex.FromPolarCoordinates(size, degrees * Math.PI / 180);
        ValidationRow[] rows = [.. StructureRows.Motion("strip", "shake", beam, 1.02 * beam, 0.99 * beam)];

        Assert.That((rows[0].Ours, rows[0].Fine), Is.EqualTo((1.02 * percent, 0.99 * percent)).Using<(double, double)>(Near));
        Assert.That((rows[0].Low, rows[0].High), Is.EqualTo((0.95 * percent, 1.05 * percent)).Using<(double, double)>(Near));
        Assert.That((rows[1].Ours, rows[1].Fine), Is.EqualTo((behind, behind)).Using<(double, double)>(Near));
        Assert.That((rows[1].Low, rows[1].High), Is.EqualTo((behind - 5, behind + 5)).Using<(double, double)>(Near));
        Assert.That(rows[0].Title, Is.EqualTo("strip: motion of the tip, % of the shake"));
        Assert.That((rows[0].Published, rows[1].Published),
            Is.EqualTo((FormattableString.Invariant($"theory: {percent:0.00}"), FormattableString.Invariant($"theory: {behind:0.0}"))));
        Assert.That(rows.Select(row => row.IsCounted), Has.None.True);
    }

    [Test]
    public void StiffnessOfTheInsects_IsThatOfAllChains_OverMeasuredWingsOfTheSpan()
    {
        bool done = false;
        ValidationRow[] rows = [.. StructureRows.Insects(new Fineness(24, 48), () => done = true)];

        Assert.That(done, Is.True);
        Assert.That(rows, Has.Length.EqualTo(InsectCatalogue.All.Count - 1), "all but the fish");
        foreach ((ValidationRow row, InsectDefinition insect) in rows.Zip(InsectCatalogue.All.Where(insect => insect.Name != "snailfish")))
        {
            using var wings = new TetheredWings(new FlightPlan { Species = insect.Name },
                Insect.Of(new FlightPlan { Species = insect.Name }));
            double usual = Math.Pow(10, 0.08 + 2.97 * Math.Log10(wings.All[0].Wing.Preset.Size.wingLength));
            Assert.That(row.Ours, Is.EqualTo(wings.All[0].Stiffness.Chains.Sum() / usual).Within(0.1).Percent);
            Assert.That((row.Fine, row.HasBand, row.IsCounted), Is.EqualTo((row.Ours, false, false)));
            Assert.That(row.Title, Does.StartWith($"{insect.Name}, {wings.All[0].Wing.Name}: "));
        }
    }

    [Test]
    public void MeasuredFlights_AreAsLongAsTheirSpeeds_AndHangTogether()
    {
        foreach ((MeasuredDragonfly flight, double speed, double degrees) in
            MeasuredDragonfly.Flights.Zip([(0.7, -12.0), (1.5, -1.1), (2.3, 4.8)], (flight, way) => (flight, way.Item1, way.Item2)))
        {
            Assert.That(Math.Sqrt(flight.Speed * flight.Speed + flight.Climb * flight.Climb), Is.EqualTo(speed).Within(1e-9));
            Assert.That(Math.Atan2(flight.Climb, flight.Speed) * 180 / Math.PI, Is.EqualTo(degrees).Within(1e-9));
            Assert.That(flight.Weight, Is.EqualTo(790e-6 * 9.81).Within(1e-9));
        }

        // Read off the published curve: the mean force carries the insect, as its authors say, to within a fifth.
        Assert.That(MeasuredDragonfly.TetheredForce, Has.Count.EqualTo(50));
        Assert.That(MeasuredDragonfly.TetheredAttack, Has.Count.EqualTo(50));
        Assert.That(MeasuredDragonfly.TetheredForce.Zip(MeasuredDragonfly.TetheredForce.Skip(1), (a, b) => Math.Abs(a - b)).Max(),
            Is.LessThan(1.0));
    }

    private static bool Near((double, double) one, (double, double) other) =>
        Math.Abs(one.Item1 - other.Item1) < 1e-6 && Math.Abs(one.Item2 - other.Item2) < 1e-6;
}
