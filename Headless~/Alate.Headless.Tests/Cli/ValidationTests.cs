using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Comparisons with published flights.</summary>
    public sealed class ValidationTests
    {
        private static readonly ValidationCurve[] s_Curves = [new("twist", "twist", [("flexible", [0.0, 1.0, 0.0, -1.0])], null),
            new("camber", "camber", [("flexible", [0.0, 0.0, 0.0, 0.0])], null)];

        // An estimate by others: 20 strips, uniform chord, no twist, the stream on the axis.
        [TestCase(0, 1.10)]
        [TestCase(1, 0.99)]
        [TestCase(2, 1.11)]
        public void BladeElements_GiveTheIndependentEstimate(int flight, double lift) =>
            Assert.That(BladeElements.Lift(MeasuredDragonfly.Flights[flight], BladeElements.Point.Axis), Is.EqualTo(lift).Within(0.01));

        [Test]
        public void TheInducedFlow_IsThatOfMomentumTheory() =>
            Assert.That(DragonflyRun.Fly(MeasuredDragonfly.Tethered, true, 48, 1).Induced, Is.EqualTo(0.93).Within(0.03));

        [Test]
        public void ATetheredDragonfly_PullsAsItWasComputed_WithAWakeFactor()
        {
            var run = DragonflyRun.Fly(MeasuredDragonfly.Tethered, true, 48, 1.2);
            double[] ours = run.Even(run.Lift, 50);

            Assert.That(DragonflyCurves.Correlation(ours, MeasuredDragonfly.TetheredForce), Is.GreaterThan(0.9));
            Assert.That(ours.Average(), Is.EqualTo(MeasuredDragonfly.TetheredForce.Average()).Within(30).Percent);
            Assert.That(ours.Max(), Is.EqualTo(MeasuredDragonfly.TetheredForce.Max()).Within(30).Percent);
        }

        // The mean of a half wave is 2/π; frames alone would miss it by half of a frame's height at both ends.
        [Test]
        public void AMeanOverAHalfBeat_CountsBothEndsOnce()
        {
            RecordedFrame[] frames = Enumerable.Range(1, 48)
                .Select(k => new RecordedFrame { Phase = (float)(2 * Math.PI * (k % 48) / 48) }).ToArray();
            var sine = new BeatCurve(frames, frames.Select(frame => Math.Sin(frame.Phase)).ToList());
            var cosine = new BeatCurve(frames, frames.Select(frame => Math.Cos(frame.Phase)).ToList());

            Assert.That(sine.Mean(0, 0.5), Is.EqualTo(2 / Math.PI).Within(0.2).Percent);
            Assert.That(cosine.Mean(0, 0.5), Is.Zero.Within(1e-6));
            Assert.That(sine.Mean(0.5, 1), Is.EqualTo(-2 / Math.PI).Within(0.2).Percent);
        }

        // Force times speed of a wing that moves as one, against blade elements of its own.
        [Test]
        public void ThePowerOfARun_IsNearThatOfBladeElements()
        {
            var run = DragonflyRun.Fly(MeasuredDragonfly.Flights[1], true, 48);
            double blades = BladeElements.Curve(MeasuredDragonfly.Flights[1], BladeElements.Point.MidChord).Average(moment => moment.Power);

            Assert.That(run.Power.Average(), Is.EqualTo(blades).Within(15).Percent);
        }

        [Test]
        public void ThePage_IsThatOfTheReport_AndTheFrontPageHasRowsOfIt()
        {
            string documentation = Path.Combine(PackageRoot.Find(), "Documentation~"), page = Text(documentation, "validation.md"),
                front = Text(PackageRoot.Find(), "README.md");
            JsonElement report = JsonDocument.Parse(Text(documentation, "validation.json")).RootElement;
            List<ValidationRow> rows = ReportRows();
            string begin = PageBlock.Begin(ValidateCommand.Part, "validate");
            string part = front[(front.IndexOf(begin, StringComparison.Ordinal) + begin.Length)..front.IndexOf(
                PageBlock.End(ValidateCommand.Part), StringComparison.Ordinal)];

            Assert.That(
                ValidationPage.Markdown(
                    rows, report.GetProperty("curves").EnumerateArray().Select(Curve).ToList(), "images/validation.svg"),
                Is.EqualTo(page), "run the command validate");
            Assert.That(part, Is.EqualTo(ValidationPage.Selection(rows)), "run the command validate");
            Assert.That(part.Split('\n'), Has.Length.GreaterThan(8));
        }

        [Test]
        public void CountedRowsOfTheReport_HaveABandOfASource_AndAreOneARecordAndQuantity()
        {
            List<ValidationRow> rows = ReportRows(), counted = rows.FindAll(row => row.IsCounted);

            Assert.That(counted.Select(row => (row.Record, row.Quantity)), Is.Unique);
            Assert.That(counted, Has.Count.InRange(15, 40));
            foreach (ValidationRow row in counted)
            {
                Assert.That(row.HasBand, row.Title);
                Assert.That(double.IsFinite(row.Low) || double.IsFinite(row.High), row.Title);
                Assert.That(row.Source, Is.Not.Empty.And.Not.EqualTo("–"), row.Title);
                // What was not measured says so.
                Assert.That(row.Published, Does.Match("^(measured|computed|known)"), row.Title);
                Assert.That(row.Band, Does.Not.Contain("ours").And.Not.Contain("tolerance"), row.Title);
                Assert.That(row.IsConverged, row.Title);
            }
        }

        [Test]
        public void EveryCountedRowOutside_HasAnExperimentWithANumber()
        {
            foreach (ValidationRow row in ReportRows().Where(row => row.IsCounted && !row.IsInside))
            {
                Assert.That(row.Experiments, Is.Not.Empty, row.Title);
                Assert.That(row.Experiments.Select(one => one.Changed), Is.Unique, row.Title);
                Assert.That(row.Experiments.All(one => double.IsFinite(one.Value)), row.Title);
                Assert.That(row.Experiments.Any(one => Math.Abs(one.Value - row.Value) > 0.02 * Math.Abs(row.Value)), row.Title);
            }
        }

        [Test]
        public void WhatIsNotCounted_IsTheory_AVariant_OrSaysWhy()
        {
            List<ValidationRow> rows = ReportRows();

            foreach (ValidationRow row in rows.Where(row => !row.IsCounted && row.Table == ValidationTable.Insects && row.Variant == null))
                Assert.That(row.Reason, Is.Not.Empty, row.Title);
            foreach (ValidationRow row in rows.Where(row => row.Variant != null))
            {
                Assert.That(rows.Any(one => one.Variant == null && one.Record == row.Record && one.Quantity == row.Quantity), row.Title);
            }
            foreach (ValidationTable table in new[] { ValidationTable.Wakes, ValidationTable.Strips })
            {
                ValidationRow[] those = [.. rows.Where(row => row.Table == table)];
                Assert.That(those.Select(row => row.IsCounted), Is.Not.Empty.And.None.True);
                Assert.That(those.Select(row => row.Published), Has.All.Match("^(theory|measured|computed): "));
            }
        }

        [Test]
        public void TheFrontPage_CountsInsectsAlone()
        {
            ValidationRow inside = new("fly", "lift", 1, 2, "measured: 1 to 2", "two flies", "s", 1.5, 1.5),
                strip = inside with { Record = "strip", Table = ValidationTable.Strips };
            string text = ValidationPage.Selection([inside, inside with { Record = "moth", Fine = 3 }, strip, strip, strip]);

            Assert.That(text, Does.StartWith("1 of 2 ").And.Contain("3 of strips").And.Not.Contain("| strip"));
            string page = ValidationPage.Markdown([inside, strip with { Fine = 3 }], s_Curves, "p.svg");
            Assert.That(page, Does.Contain("1 of 1 rows of insects agree").And.Contain("0 of 1 lie in it"));
        }

        // Its published angles beside blade elements apart from the model.
        [Test]
        public void TheMeasuredAngleOfAttack_IsThatOfTheMeasuredMotion()
        {
            List<BladeElements.Moment> blades = BladeElements.Curve(MeasuredDragonfly.Tethered, BladeElements.Point.Axis);
            double[] ours = Enumerable.Range(0, 50).Select(n => blades[n * blades.Count / 50].Attack).ToArray();

            Assert.That(DragonflyCurves.Correlation(ours, MeasuredDragonfly.TetheredAttack), Is.GreaterThan(0.9));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void ADragonflysOwnDrag_TakesMostOfTheNegativeThrust(int flight)
        {
            double ours = BladeElements.Thrust(MeasuredDragonfly.Flights[flight], BladeElements.Point.MidChord),
                own = BladeElements.Thrust(MeasuredDragonfly.Flights[flight], BladeElements.Point.MidChord, ownDrag: true);

            Assert.That(own, Is.GreaterThan(0.25 * ours), "thrust over weight, both below 0 or the second above");
        }

        // The body is held still, its sweep at its bound, so that all that is left over goes into the pitch: 51° at 16 substeps.
        [Test]
        public void AClimbingTrim_HardlyDependsOnTheSubsteps()
        {
            TrimState trim = FreeMonarch.Climb(64, null, (0, 0), out _);

            Assert.That(180 / Math.PI * trim.Pitch, Is.EqualTo(46.1).Within(5).Percent, "the page's at 240 substeps");
            Assert.That(trim.PitchBob, Is.Zero);
        }

        [Test]
        public void AFrontPageWithoutTheParts_IsRefusedBeforeAnythingIsFlown()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("validate", "--readme", run.Write("README.md", "# A page\n"), "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("validation: written by the command validate"));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void ARow_SaysHowFarItIsOutside_ByItsFinestValue()
        {
            var row = new ValidationRow("", "", 1, 2, "", "two", "", 1.5, 2.25);

            Assert.That((row.IsInside, row.Distance), Is.EqualTo((false, 0.25)));
            Assert.That(row.Change, Is.EqualTo(1.0 / 3).Within(1e-9));
            Assert.That(row with { Fine = double.NaN }, Has.Property(nameof(ValidationRow.IsInside)).True);
        }

        // Three per cent, or a fifth of a band.
        [TestCase(97.05, 100, 100.1, true)]
        [TestCase(96.8, 100, 100.1, false)]
        [TestCase(96.8, 90, 106.1, true)]
        [TestCase(96.8, 90, 105.9, false)]
        public void ARow_IsConvergedWhereItHardlyChanges(double ours, double low, double high, bool converged) =>
            Assert.That(new ValidationRow("", "", low, high, "", "two", "", ours, 100).IsConverged, Is.EqualTo(converged));

        [Test]
        public void ThePage_HasTheRowsOutsideFirst_WithTheirExperiments_AndVariantsInAFold()
        {
            ValidationRow good = new("good", "lift", 1, 2, "1 to 2", "two", "s", 1.5, 1.5);
            ValidationRow[] rows =
            [
                good, good with { Record = "bad", Fine = 3, Experiments = [new("no wake", 1.25), new("rigid", 4)] },
                good with { Variant = "soft", Fine = 7 }, good with { Record = "lone", Band = "", Reason = "one value", Fine = 8 },
            ];

            string page = ValidationPage.Markdown(rows, s_Curves, "p.svg");
            string[] order = ["| bad: lift | 1 to 2 |", "| bad: lift | no wake | 3.00 | 1.25 | inside |",
                "| bad: lift | rigid | 3.00 | 4.00 | outside |", "| good: lift |", "<details>", "| lone: lift |", "one value", "</details>",
                "<details>", "| good, soft: lift |", "</details>"];
            int at = 0;
            foreach (string part in order)
            {
                at = page.IndexOf(part, at, StringComparison.Ordinal);
                Assert.That(at, Is.GreaterThan(0), part);
                at += part.Length;
            }

            Assert.That(page, Does.Contain("outside by 1.00").And.Contain("1 of 2 rows of insects agree"));
            Assert.That(JsonDocument.Parse(ValidationJson.Write(rows, s_Curves)).RootElement.GetProperty("rows")[1].GetProperty("distance")
                .GetDouble(), Is.EqualTo(1));
        }

        [Test]
        public void AUsersCurve_IsReadBetweenItsRows_AndGetsARow()
        {
            using var run = new CommandRun();
            run.Write("twist.csv", "t/T,twist\n0,0\n0.25,2\n0.5,0\n0.75,-2\n");

            List<ValidationCurve> curves = UserCurves.Read(run.Folder, s_Curves);

            Assert.That(curves[0].Measured, Is.EqualTo(new[] { 0.0, 2, 0, -2 }));
            Assert.That(curves[1].Measured, Is.Null);
            Assert.That(
                UserCurves.Rows(curves).Select(row => row.Ours), Is.EqualTo(new[] { 1.0, 0.5 }).Within(1e-9), "correlation and size");
        }

        [Test]
        public void AHoleInAUsersCurve_IsNotComparedWith()
        {
            using var run = new CommandRun();
            run.Write("twist.csv", "t/T,twist (deg)\n0.1,1\n0.2,1\n0.3,1\n0.4,0\n0.8,0\n0.9,0\n1,1\n");
            ValidationCurve[] ours = [s_Curves[0] with { Ours = [("flexible", [0, 0, 0, 0, 0, 7, 7, 7, 0, 0])] }];

            List<ValidationCurve> curves = UserCurves.Read(run.Folder, ours);

            Assert.That(curves[0].Measured, Is.EqualTo(new[] { 1, 1, 1, 1, 0, double.NaN, double.NaN, double.NaN, 0, 0 }));
            Assert.That(DragonflyCurves.Correlation([1, 2, 3, 50], [2, 4, 6, double.NaN]), Is.EqualTo(1).Within(1e-9));
            Assert.That(JsonDocument.Parse(ValidationJson.Write([], curves)).RootElement.GetProperty("curves")[0]
                .GetProperty("measured")[5].ValueKind, Is.EqualTo(JsonValueKind.Null));
        }

        [TestCase("lift.csv", "0,1", "there is no such curve. Known: twist.csv, camber.csv.")]
        [TestCase("twist.csv", "0,1\n0.5,1\n", "it has 2 rows; a beat needs at least three.")]
        [TestCase("twist.csv", "0,1\n0.5,x\n", "line 2: '0.5,x' is not t/T and a value.")]
        [TestCase("twist.csv", "0,1\n0.5\n", "line 2: '0.5' is not t/T and a value.")]
        [TestCase("twist.csv", "0,1\n0.5,2\n0.4,3\n", "line 3: 0.4 is not after the row before it and between 0 and 1.")]
        [TestCase("twist.csv", "t/T,twist,camber\n0,1,2\n", "line 1: 't/T,twist,camber' is not a heading of two columns, t/T and value.")]
        [TestCase("twist.csv", "t/T,twist (rad)\n0,1\n", "line 1: the unit 'rad' is not one of °, deg, degrees.")]
        [TestCase("twist.csv", "0,1\n0.5,NaN\n", "line 2: '0.5,NaN' is not t/T and a value.")]
        [TestCase("twist.csv", "0,1\n0.5,181\n", "line 2: 181 is not between -180 and 180 (°).")]
        [TestCase("twist.csv", "0,1\n0.5,1\n0.7,1\n", "all its values are 1; there is nothing to compare.")]
        [TestCase("twist.csv", "0,0\n0.01,1\n0.02,0\n0.03,1\n0.04,0\n", "its rows cover less than half of the beat.")]
        public void ABadCurve_IsOneLine(string name, string text, string message)
        {
            using var run = new CommandRun();
            string path = run.Write(name, text);

            Assert.That(
                () => UserCurves.Read(run.Folder, s_Curves), Throws.TypeOf<UserException>().With.Message.EqualTo($"{path}: {message}"));
        }

        private static string Text(params string[] path) => File.ReadAllText(Path.Combine(path)).ReplaceLineEndings("\n");

        private static List<ValidationRow> ReportRows() =>
            [.. JsonDocument.Parse(Text(PackageRoot.Find(), "Documentation~", "validation.json")).RootElement.GetProperty("rows")
                .EnumerateArray().Select(Row)];

        private static ValidationRow Row(JsonElement row) => new(
            row.GetProperty("record").GetString(), row.GetProperty("quantity").GetString(), Number(row, "low", double.NegativeInfinity),
            Number(row, "high", double.PositiveInfinity), row.GetProperty("published").GetString(), row.GetProperty("band").GetString(),
            row.GetProperty("source").GetString(), Number(row, "ours", double.NaN), Number(row, "at_twice_the_substeps", double.NaN))
        {
            Table = Enum.Parse<ValidationTable>(row.GetProperty("table").GetString(), true),
            Variant = row.GetProperty("variant").GetString(),
            Reason = row.GetProperty("reason").GetString(),
            Experiments = [.. row.GetProperty("experiments").EnumerateArray().Select(one =>
                new ValidationExperiment(one.GetProperty("changed").GetString(), Number(one, "value", double.NaN)))],
        };

        private static ValidationCurve Curve(JsonElement curve) =>
            new("", curve.GetProperty("title").GetString(), [], null, curve.GetProperty("published").GetString());

        private static double Number(JsonElement row, string name, double missing) =>
            row.GetProperty(name) is { ValueKind: JsonValueKind.Number } number ? number.GetDouble() : missing;

        [Test]
        public void AFolderThatIsNotThere_OrIsEmpty_IsRefused()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("validate", "--data", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("there is no such folder"));
            Assert.That(
                () => UserCurves.Read(run.Folder, s_Curves), Throws.TypeOf<UserException>().With.Message.Contains("has no CSV file"));
        }
    }
}
