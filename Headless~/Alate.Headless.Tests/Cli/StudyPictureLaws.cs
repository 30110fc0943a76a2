using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Charts of studies: each point of made-up measurements lies where its numbers say, in the colour and look of its kind.</summary>
public sealed class StudyPictureLaws
{
    private static readonly XNamespace s_Svg = "http://www.w3.org/2000/svg";

    [Test]
    public void ErrorsOverCosts_HaveACurveAScheme_ARingAtTheDefaults_AndACrossForTheOldVersion()
    {
        ConvergencePoint At(TimeScheme scheme, int substeps, double error, double cost) => new(scheme, substeps, error, cost);
        ConvergencePoint ring = At(TimeScheme.SecondOrder, 24, 0.2, 1.5), old = At(TimeScheme.BackwardEuler, 24, 2.5, 1.0);
        ConvergencePoint[] points =
        [
            At(TimeScheme.SecondOrder, 12, 0.9, 0.6), ring, At(TimeScheme.BackwardEuler, 12, 5.0, 0.5),
                At(TimeScheme.BackwardEuler, 24, 3.0, 1.1),
        ];
        var wing = new WingConvergence("fore wing", points, ring, old, []);
        var hind = new WingConvergence("hind wing", [.. points.Select(point => point with { ErrorPct = 2 * point.ErrorPct })],
            ring with { ErrorPct = 0.4 }, old with { ErrorPct = 7.0 }, []);
        var species = new SpeciesConvergence(new FlightPlan { Species = "firefly", Variant = InsectVariant.Expressive }, "Firefly",
            [wing, hind]);
        var svg = XElement.Parse(ConvergencePicture.Draw([species]));
        // Costs 0.5 to 1.5 stand between 0.5 and 2, errors 0.2 to 10 between these.
        double X(double cost) => 56.0 + (974.0 / 3.0 - 58.0) * Math.Log(cost / 0.5) / Math.Log(4.0);
        double Y(double error) => 390.0 - 220.0 * Math.Log(error / 0.2) / Math.Log(50.0);

        AssertPlaces(Curves(svg, "#0b5fa5", null), [(0.6, 0.9), (1.5, 0.2)], X, Y);
        AssertPlaces(Curves(svg, "#0b5fa5", "5 4"), [(0.5, 5.0), (1.1, 3.0)], X, Y);
        AssertPlaces(Curves(svg, "#c2410c", null), [(0.6, 1.8), (1.5, 0.4)], X, Y);
        XElement ringed = svg.Elements(s_Svg + "circle").Single(circle => (string)circle.Attribute("r") == "6.5"
            && (string)circle.Attribute("stroke") == "#0b5fa5");
        Assert.That((Number(ringed, "cx"), Number(ringed, "cy")), Is.EqualTo((X(1.5), Y(0.2))).Using<(double, double)>(Near));
        double[] cross = Numbers((string)svg.Elements(s_Svg + "path").Single(path =>
            ((string)path.Attribute("d")).Contains("l8 8") && (string)path.Attribute("stroke") == "#c2410c").Attribute("d"));
        Assert.That((cross[0] + 4.0, cross[1] + 4.0), Is.EqualTo((X(1.0), Y(7.0))).Using<(double, double)>(Near));
        string[] texts = Texts(svg);
        Assert.That(texts[..2], Is.EqualTo(new[]
        {
            "How far wings are off, and what they cost, expressive",
            "Distance of the joints from 480 substeps of the same scheme, RMS, % of the wing's length, "
            + "over the time of a beat, version 0.1 = 1.",
        }));
        Assert.That(texts, Is.SupersetOf(new[]
        {
            "second order (default)", "backward Euler", "default substeps", "version 0.1", "fore wing, or the only one", "hind wing",
                "Firefly",
            "Points from left to right: 12, 16, 24, 32, 48, 96 substeps; more where the air is fast.",
        }));
        Assert.That(svg.Element(s_Svg + "title").Value, Is.EqualTo("Error of the joints over the cost of a beat"));
    }

    [TestCase(InsectVariant.Standard, false)]
    [TestCase(InsectVariant.Expressive, true)]
    public void StretchOverWind_HasThreeCurvesAWing_ItsLimits_AndWhatGoesBeyond(InsectVariant variant, bool inGusts)
    {
        WindPoint At(double speed, double most, double p99) => new(speed, most, p99, null, 0, 0);
        WingWinds wing = new("wing", [At(0, 2, 1), At(4, 8, 5), At(8, 14, 9)], [At(0, 3, 1), At(4, 20, 9), At(8, 1234, 50)]);
        var plan = new FlightPlan { Species = "monarch", Variant = variant };
        var svg = XElement.Parse(WindPicture.Draw([new SpeciesWinds(plan, "Monarch", 1.0, [wing]),
            new SpeciesWinds(plan, "Fish", 0.1, [wing])], inGusts));
        double high = variant == InsectVariant.Expressive ? 60.0 : 30.0;
        double X(double speed) => 56.0 + (974.0 / 3.0 - 58.0) * speed / 8.0;
        double Y(double stretch) => 390.0 - 220.0 * stretch / high;
        XElement[] first = [.. svg.Elements(s_Svg + "path").Where(path => ((string)path.Attribute("clip-path")) == "url(#c12-136)")];
        string[] texts = Texts(svg);

        Assert.That(svg.Element(s_Svg + "title").Value,
            Is.EqualTo(inGusts ? "Stretch of wings over the speed of gusts" : "Stretch of wings over the speed of wind"));
        Assert.That(texts.Count(text => text.Contains("over the speed of " + (inGusts ? "gusts" : "a steady wind"))), Is.EqualTo(1));
        Assert.That(first, Has.Length.EqualTo(4), "limits, both versions' largest, a percentile");
        double[] limits = variant == InsectVariant.Expressive ? [15, 20, 28] : [10, 12, 15];
        AssertPlaces(first[0], [(0, limits[0]), (3, limits[0]), (3, limits[1]), (5, limits[1]), (5, limits[2]), (8, limits[2])], X, Y);
        AssertPlaces(first[1], [(0, 3), (4, 20), (8, 1234)], X, Y);
        AssertPlaces(first[2], [(0, 1), (4, 5), (8, 9)], X, Y);
        AssertPlaces(first[3], [(0, 2), (4, 8), (8, 14)], X, Y);
        // A tenth of the speeds in water: all its limits end before one metre a second.
        XElement water = svg.Elements(s_Svg + "path").First(path => (string)path.Attribute("clip-path") == "url(#c337-136)");
        AssertPlaces(water, [(0, limits[0]), (0.3, limits[0]), (0.3, limits[1]), (0.5, limits[1]), (0.5, limits[2]), (1, limits[2])],
            speed => 974.0 / 3.0 + X(speed), Y);
        Assert.That(texts, Is.SupersetOf(new[]
        {
            "Monarch", "Fish, in water", "0.1: up to 1,234 %", "largest", "99th percentile", "largest, version 0.1", "wing",
            $"limit of the largest: {string.Join(", ", limits)} %",
            (inGusts ? "What gusts do to wings" : "What wind does to wings") + (variant == InsectVariant.Expressive ? ", expressive" : ""),
        }));
        Assert.That(texts[1], Does.Contain(inGusts ? "over the speed of gusts, m/s" : "over the speed of a steady wind, m/s"));
        for (int k = 0; k <= 6; k++)
            Assert.That(texts, Does.Contain($"{k * high / 6:0}"));
    }

    [Test]
    public void Trims_HaveAChartANumber_ALineAClimb_AndHolesWhereNothingCloses()
    {
        TrimRow Row(double speed, double climb, double shift, bool closes = true) => new(
            speed, climb, closes, shift + 1, shift + 2, shift + 3, shift + 4, 9, shift + 5, shift + 6, shift + 7, 0, 0, 0,
                closes ? null : "lift");
        TrimRow[] rows = [Row(2, 0, 10), Row(1, 0, 0), Row(1, -0.5, 20), Row(2, -0.5, 30, false), Row(3, 0, 5), Row(3, -0.5, 8)];
        var svg = XElement.Parse(TrimPicture.Draw(InsectCatalogue.Find("monarch"), rows));
        XElement[] lines = [.. svg.Elements(s_Svg + "path")];
        (string Title, double Add)[] charts =
        [
            ("Pitch, °", 1), ("Frequency, Hz", 3), ("Flap from end to end, °", 4), ("Tilt of the stroke, °", 5),
                ("Middle of the stroke ahead, °", 6),
            ("Bob of the pitch, ±°", 2), ("Power to the air, mW", 7),
        ];

        Assert.That(lines, Has.Length.EqualTo(2 * charts.Length));
        for (int k = 0; k < charts.Length; k++)
        {
            double add = charts[k].Add, left = 56.0 + 500.0 * (k % 2), top = 102.0 + 280.0 * (k / 2), height = 230.0;
            var up = ChartAxis.Linear(new[] { 0.0, 10, 20, 5, 8 }.Select(shift => shift + add));
            double X(double speed) => left + (480.0 - 56.0) * (speed - 1) / 2;
            double Y(double value) => top + height * (up.To - value) / (up.To - up.From);
            Assert.That(((string)lines[2 * k].Attribute("stroke"), (string)lines[2 * k + 1].Attribute("stroke")),
                Is.EqualTo(("#0b5fa5", "#3d3a34")));
            AssertPlaces(lines[2 * k], [(1, 20 + add), (3, 8 + add)], X, Y);
            AssertPlaces(lines[2 * k + 1], [(1, add), (2, 10 + add), (3, 5 + add)], X, Y);
        }

        string[] texts = Texts(svg);
        Assert.That(texts[..2], Is.EqualTo(new[] { "Monarch: trim over speed",
            "Speed ahead, m/s. Lines: climb −0.5, 0 m/s, from blue to red." }));
        Assert.That(texts.Intersect(charts.Select(chart => chart.Title)), Is.EqualTo(charts.Select(chart => chart.Title)));
        Assert.That((string)svg.Attribute("viewBox"), Is.EqualTo($"0 0 1012 {88 + 4 * 280}"));
    }

    [Test]
    public void TrimsOfOneSpeed_AreDrawnOverTheClimb_AndOnePointIsTold()
    {
        TrimRow[] rows =
            [.. new[] { 1.0, -0.5, 0 }.Select(climb => new TrimRow(1.3, climb, true, climb + 1, 2, 3, 4, 9, 5, 6, 7, 0, 0, 0, null))];
        var svg = XElement.Parse(TrimPicture.Draw(InsectCatalogue.Find("monarch"), rows));
        var up = ChartAxis.Linear(new[] { 0.5, 1, 2 });
        AssertPlaces(svg.Elements(s_Svg + "path").First(), [(-0.5, 0.5), (0, 1), (1, 2)], climb => 56 + 424 * (climb + 0.5) / 1.5,
            value => 102 + 230 * (up.To - value) / (up.To - up.From));
        Assert.That(Texts(svg)[..2], Is.EqualTo(new[] { "Monarch: trim over climb", "Climb, m/s, at 1.3 m/s ahead." }));

        svg = XElement.Parse(TrimPicture.Draw(InsectCatalogue.Find("monarch"), rows[..1]));
        Assert.That(Texts(svg), Is.EqualTo(new[] { "Monarch: trim over climb", "One point has no curves; trim.csv has its numbers." }));
    }

    [Test]
    public void CurvesOfAValidation_AreClosed_AndBreakWhereNothingWasMeasured()
    {
        ValidationCurve one = new("a", "first", [("rigid", [0, 1, 2, 1]), ("flexible", [1, 1, 3, 1])], [1, double.NaN, 2, 2.5],
            "published"),
            other = new("b", "second", [("blade elements", [4, 3, 2, 3])], null, "nothing");
        var svg = XElement.Parse(ValidationCharts.Draw([one, other, one]));
        double X(double turn) => 56.0 + 422.0 * turn;
        double Y(double value) => 332.0 - 190.0 * value / 3.0;
        XElement[] first = [.. svg.Elements(s_Svg + "path").Where(path => (string)path.Attribute("clip-path") == "url(#c12-108)")];

        Assert.That(first, Has.Length.EqualTo(4));
        AssertPlaces(first[0], [(0, 0), (0.25, 1), (0.5, 2), (0.75, 1), (1, 0)], X, Y);
        AssertPlaces(first[1], [(0, 1), (0.25, 1), (0.5, 3), (0.75, 1), (1, 1)], X, Y);
        AssertPlaces(first[2], [(0, 1)], X, Y);
        AssertPlaces(first[3], [(0.5, 2), (0.75, 2.5), (1, 1)], X, Y);
        Assert.That(first.Select(path => (string)path.Attribute("stroke")),
            Is.EqualTo(new[] { "#0b5fa5", "#c2410c", "#3d3a34", "#3d3a34" }));
        Assert.That(svg.Elements(s_Svg + "path").Select(path => (string)path.Attribute("clip-path")).Where(clip => clip != null).Distinct(),
            Is.EqualTo(new[] { "url(#c12-108)", "url(#c502-108)", "url(#c12-358)" }));
        Assert.That((string)svg.Attribute("viewBox"), Is.EqualTo($"0 0 1000 {108 + 2 * 250 + 12}"));
        Assert.That(Texts(svg), Is.SupersetOf(new[] { "rigid", "flexible", "blade elements, apart from the model",
            "published, or of --data", "first", "second" }));
        Assert.That(Texts(svg), Has.None.EqualTo("no induced flow"));
    }

    // A sweep of two values with and without the wave: every chart is the one of its numbers.
    [Test]
    public void ChartsOfASweep_AreThoseOfItsPoints()
    {
        var flight = new FlightPlan { Species = "fishfly", Substeps = 12, Patches = 64 };
        var told = new List<int>();
        var sweep = Sweep.Fly(new SweepPlan(FlownParameters.Find("elasticity"), 0.5, 8.0, 2, flight, SweepWaves.Both), told.Add);
        var svg = XElement.Parse(SweepPicture.DrawCharts(sweep));
        (string Title, Func<SweepPoint, int, double> Of)[] charts =
        [
            ("twist, peak to peak, °", (point, kind) => point.Summary.Wings[kind].TwistPpDeg),
            ("camber by the loads, % of the chord", (point, kind) => point.LoadCamberPct[kind]),
            ("lag of the tip, °", (point, kind) => point.Summary.Wings[kind].TipLagDeg),
            ("tip bend, peak to peak, °", (point, kind) => point.Summary.Wings[kind].TipBendPpDeg),
            ("edge stretch, largest, %", (point, kind) => point.Summary.Wings[kind].EdgeStretchMaxPct),
            ("lift over weight, all wings", (point, kind) => kind == 0 ? point.Summary.LiftOverWeight : double.NaN),
        ];
        var page = new SvgPage();
        for (int k = 0; k < charts.Length; k++)
        {
            var curves = new List<ChartCurve>();
            foreach (bool wave in new[] { true, false })
            {
                for (int kind = 0; kind < (k == 5 ? 1 : 2); kind++)
                {
                    double[] values = [.. sweep.Points.Where(point => point.HasWave == wave).Select(point => charts[k].Of(point, kind))];
                    curves.Add(new ChartCurve(values, kind == 0 ? "#0b5fa5" : "#c2410c", !wave));
                }
            }

            // Below the heading and the legend, three beside one another.
            new LineChart([0.5, 8.0], true, 12f + k % 3 * 974f / 3f, 82f + k / 3 * 170f, 974f / 3f, 170f).Draw(page, charts[k].Title,
                curves);
        }

        string[] drawn = [.. svg.Elements().Select(element => element.ToString())],
            expected = [.. XElement.Parse(page.Finish(1f, 1f, "")).Elements().Skip(3).Select(element => element.ToString())];
        Assert.That(drawn[^expected.Length..], Is.EqualTo(expected));
        string[] texts = Texts(svg);
        Assert.That(texts[..6], Is.EqualTo(new[] { "Fishfly", "fore wing", "hind wing", "with the wave", "without",
            "over elasticity, × the species'" }));
        double[] x = [.. svg.Elements(s_Svg + "text").Skip(1).Take(5).Select(text => Number(text, "x"))];
        for (int k = 0; k < 4; k++)
        {
            Assert.That(x[k + 1] - x[k], Is.EqualTo(54.0 + 7.2 * texts[k + 1].Length - (k == 3 ? 32.0 : 0.0)).Within(0.1),
                "each as long as its words");
        }

        Assert.That((string)svg.Attribute("viewBox"), Is.EqualTo("0 0 1000 436"), "82 and two rows of 170, and 14");
        Assert.That(told, Is.EqualTo(new[] { 1, 2, 3, 4 }));
        Assert.That(Sweep.Flights(sweep.Plan), Is.EqualTo(4));
        Assert.That(svg.Element(s_Svg + "title").Value, Is.EqualTo("Fishfly: elasticity, × the species'"));
    }

    private static XElement Curves(XElement svg, string colour, string dash) => svg.Elements(s_Svg + "path").Single(path =>
        path.Attribute("clip-path") != null && (string)path.Attribute("stroke") == colour
            && (string)path.Attribute("stroke-dasharray") == dash);

    private static void AssertPlaces(XElement path, (double X, double Y)[] points, Func<double, double> x, Func<double, double> y)
    {
        double[] drawn = Numbers((string)path.Attribute("d"));
        Assert.That(drawn, Has.Length.EqualTo(2 * points.Length), path.ToString());
        for (int k = 0; k < points.Length; k++)
        {
            Assert.That((drawn[2 * k], drawn[2 * k + 1]), Is.EqualTo((x(points[k].X), y(points[k].Y))).Using<(double, double)>(Near),
                $"{points[k]} on {path}");
        }
    }

    private static bool Near((double, double) one, (double, double) other) =>
        Math.Abs(one.Item1 - other.Item1) < 0.11 && Math.Abs(one.Item2 - other.Item2) < 0.11;

    private static string[] Texts(XElement svg) => [.. svg.Elements(s_Svg + "text").Select(text => text.Value)];

    private static double Number(XElement element, string name) => double.Parse((string)element.Attribute(name),
        CultureInfo.InvariantCulture);

    private static double[] Numbers(string text) =>
        [.. Regex.Matches(text, @"-?\d+(\.\d+)?").Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture))];
}
