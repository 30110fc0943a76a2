using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Rows and curves of the manual's report, flown with few substeps: the same words and bands, nearly its numbers.</summary>
public sealed class ReportRowLaws
{
    private static readonly Regex s_Number = new(@"[−-]?\d+(\.\d+)?");

    private static readonly Lazy<JsonElement> s_Report = new(() => JsonDocument.Parse(
        File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", "validation.json"))).RootElement);

    private static readonly Fineness s_Coarse = new(48, 96);

    [Test]
    [Explicit]
    [Category("Long")]
    public void FlightsOfDragonflies_AreThoseOfTheReport() =>
        Compare(row => Best(row) && (Begins(row, "dragonfly, flight") || Begins(row, "small dragonfly")), 5,
            done => DragonflyRows.Flights(s_Coarse, done), 0.05, 0.03, false);

    [Test]
    [Explicit]
    [Category("Long")]
    public void ATetheredDragonfly_IsThatOfTheReport() =>
        Compare(row => Best(row) && Begins(row, "tethered dragonfly") && !Begins(row, "tethered dragonfly in still air"), 1,
            done => DragonflyRows.Tethered(s_Coarse, done), 0.05, 0.03, false);

    [Test]
    [Explicit]
    [Category("Long")]
    public void VariantsOfFlights_AreThoseOfTheReport() =>
        Compare(row => !Best(row) && Begins(row, "dragonfly, flight"), 15,
            done => DragonflyVariants.Flights(new Fineness(16, 32), done), 0.05, 0.03);

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void VariantsOfATetheredDragonfly_AreThoseOfTheReport() =>
        Compare(row => (!Best(row) && Begins(row, "tethered dragonfly")) || Begins(row, "tethered dragonfly in still air")
            || Begins(row, "hovering dragonfly"), 5, done => DragonflyVariants.Tethered(new Fineness(24, 48), done), 0.05, 0.03);

    [TestCase("monarch")]
    [TestCase("swallowtail", Explicit = true, Category = "Long")]
    public void AButterfly_IsThatOfTheReport(string species) =>
        Compare(row => Begins(row, species + ", free flight"), 1,
            done => FreeRows.Butterfly(species, new Fineness(16, 32), done, false), 0.25, 0.1, false);

    [Test]
    [Explicit]
    [Category("Long")]
    public void MothAndFirefly_AreThoseOfTheReport()
    {
        Compare(row => Begins(row, "painted-lichen-moth, free flight"), 1,
            done => FreeRows.Moth(new Fineness(16, 32), done), 0.2, 0.1, false);
        Compare(row => Begins(row, "firefly, free flight"), 1, done => FreeRows.Firefly(new Fineness(16, 32), done), 0.2, 0.1, false);
    }

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void AClimbingMonarch_IsThatOfTheReport() =>
        Compare(row => Begins(row, "monarch, climbing"), 1, done => ButterflyRows.Climbing(new Fineness(64, 128), done), 0.06, 0.1, false);

    [Test]
    public void AHeldMonarch_IsThatOfTheReport() =>
        Compare(row => Begins(row, "monarch held "), 2, done => ButterflyRows.Held(new Fineness(64, 128), done), 0.35, 0.05, false);

    [Test]
    public void StripsThatDroop_AreThoseOfTheReport() =>
        Compare(row => Text(row, "record").Contains("under a weight of"), 1,
            done => StructureRows.Droops(new Fineness(12, 24), done), 0.005, 0.001);

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void StripsThatMove_AreThoseOfTheReport() =>
        Compare(row => Text(row, "table") == "strips" && !Text(row, "record").Contains("under a weight of"), 1,
            done => StructureRows.Motions(new Fineness(48, 96), done), 0.08, 1.5);

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void Wakes_AreThoseOfTheReport() =>
        Compare(row => Text(row, "table") == "wakes", 7,
            done => WakeRows.Beating(done).Concat(WakeRows.Starting(done)).Concat(WakeRows.Steady(done)).Concat(WakeRows.Formation(done))
                .Concat(WakeRows.Revolving(done)).Concat(WakeRows.Hovering(done)).Concat(WakeRows.Flapping(done)),
            1e-3, 1e-3, false);

    [Test]
    public void AWingThatRevolves_IsThatOfTheReport() =>
        Compare(row => Begins(row, "wing that revolves"), 1, WakeRows.Revolving, 1e-3, 1e-3, false);

    [Test]
    public void AFlyThatHovers_IsThatOfTheReport() =>
        Compare(row => Begins(row, "fruit fly that hovers"), 1, WakeRows.Hovering, 1e-3, 1e-3, false);

    [Test]
    public void StiffnessOfTheInsects_IsThatOfTheReport() =>
        Compare(row => Text(row, "quantity").Contains("flexural stiffness EI"), 1,
            done => StructureRows.Insects(new Fineness(16, 24), done), 0.001, 1e-5, false);

    [Test]
    public void CurvesOverTheBeat_AreThoseOfTheReport()
    {
        JsonElement[] told = [.. s_Report.Value.GetProperty("curves").EnumerateArray()];
        List<ValidationCurve> curves = DragonflyCurves.Make(48);

        Assert.That(curves.Select(curve => (curve.Key, curve.Title, curve.Published)),
            Is.EqualTo(told.Select(curve => (Text(curve, "key"), Text(curve, "title"), Text(curve, "published")))));
        for (int k = 0; k < told.Length; k++)
        {
            JsonProperty[] lines = [.. told[k].GetProperty("ours").EnumerateObject()];
            Assert.That(curves[k].Ours.Select(line => line.Name), Is.EqualTo(lines.Select(line => line.Name)), curves[k].Key);
            for (int line = 0; line < lines.Length; line++)
            {
                double[] ours = curves[k].Ours[line].Values, theirs = [.. lines[line].Value.EnumerateArray().Select(at => at.GetDouble())];
                Assert.That(ours, Has.Length.EqualTo(theirs.Length));
                double range = theirs.Max() - theirs.Min();
                Assert.That(ours.Zip(theirs, (a, b) => Math.Abs(a - b)).Average(), Is.LessThan(0.04 * range),
                    $"{curves[k].Key}, {lines[line].Name}");
            }
        }

        // What a user's file of each may have, by the manual: degrees in half a turn, weights, per cent, watts.
        Assert.That(curves.Select(curve => (curve.Units[0], curve.Range)), Is.EqualTo(new (string, (double, double))[]
        {
            ("weights", (-100, 100)), ("°", (0, 90)), ("°", (-180, 180)), ("%", (-100, 100)), ("°", (-180, 180)), ("W/kg", (-10000, 10000)),
        }));
    }

    private static bool Best(JsonElement row) => row.GetProperty("variant").ValueKind == JsonValueKind.Null;

    private static bool Begins(JsonElement row, string begin) => Text(row, "record").StartsWith(begin, StringComparison.Ordinal);

    private static void Compare(Func<JsonElement, bool> isOne, int stages, Func<Action, IEnumerable<ValidationRow>> make, double relative,
        double absolute, bool converges = true)
    {
        int done = 0;
        ValidationRow[] rows = [.. make(() => done++)];
        JsonElement[] told = [.. s_Report.Value.GetProperty("rows").EnumerateArray().Where(isOne)];

        Assert.That(done, Is.EqualTo(stages));
        Assert.That(rows, Has.Length.EqualTo(told.Length));
        double off = 0, fineOff = 0;
        for (int k = 0; k < rows.Length; k++)
        {
            string title = rows[k].Title;
            Assert.That((rows[k].Record, rows[k].Quantity), Is.EqualTo((Text(told[k], "record"), Text(told[k], "quantity"))));
            Alike(rows[k].Variant ?? "", Text(told[k], "variant") ?? "", title);
            Alike(rows[k].Reason ?? "", Text(told[k], "reason") ?? "", title);
            Assert.That((rows[k].Published, rows[k].Band, rows[k].Source),
                Is.EqualTo((Text(told[k], "published"), Text(told[k], "band"), Text(told[k], "source"))), title);
            Assert.That(rows[k].Low, Is.EqualTo(Number(told[k], "low") ?? double.NegativeInfinity).Within(1e-6), title);
            Assert.That(rows[k].High, Is.EqualTo(Number(told[k], "high") ?? double.PositiveInfinity).Within(1e-6), title);
            if (!double.IsFinite(rows[k].Ours) || Math.Abs(rows[k].Ours) > 1000)
                continue;
            double limit = Number(told[k], "at_twice_the_substeps").Value, bound = relative * Math.Abs(limit) + absolute;
            Assert.That(rows[k].Ours, Is.EqualTo(Number(told[k], "ours")).Within(bound), title);
            Assert.That(rows[k].Fine, Is.EqualTo(limit).Within(bound), title);
            off += Math.Abs(rows[k].Ours - limit) / bound;
            fineOff += Math.Abs(rows[k].Fine - limit) / bound;
        }

        if (converges)
            Assert.That(fineOff, Is.LessThan(off), "more substeps are nearer to the limit");
    }

    // The same words, and numbers that are near one another.
    private static void Alike(string ours, string told, string title)
    {
        Assert.That(s_Number.Replace(ours, "#"), Is.EqualTo(s_Number.Replace(told, "#")), title);
        double[] numbers = Numbers(ours), others = Numbers(told);
        // A ratio of more than ten is one over next to nothing.
        foreach (int k in Enumerable.Range(0, numbers.Length).Where(k => Math.Abs(others[k]) < 1000))
            Assert.That(numbers[k], Is.EqualTo(others[k]).Within(0.08 * Math.Abs(others[k]) + 0.03), $"{title}: {ours}");
    }

    private static double[] Numbers(string text) =>
        [.. s_Number.Matches(text).Select(match => double.Parse(match.Value.Replace('−', '-'), CultureInfo.InvariantCulture))];

    private static string Text(JsonElement row, string name) => row.GetProperty(name).GetString();

    private static double? Number(JsonElement row, string name) =>
        row.GetProperty(name) is { ValueKind: JsonValueKind.Number } number ? number.GetDouble() : null;
}
