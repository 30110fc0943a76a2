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

            Assert.That(DragonflyRows.Correlation(ours, MeasuredDragonfly.TetheredForce), Is.GreaterThan(0.9));
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
            var rows = report.GetProperty("rows").EnumerateArray().Select(Row).ToList();
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
        public void TheReport_SaysOfEveryRow_WhereItIsFrom_AndEveryRowIsConverged()
        {
            JsonElement report = JsonDocument.Parse(Text(PackageRoot.Find(), "Documentation~", "validation.json")).RootElement;
            foreach (JsonElement row in report.GetProperty("rows").EnumerateArray())
            {
                string title = row.GetProperty("title").GetString();
                foreach (string name in new[] { "measured", "source", "verdict" })
                    Assert.That(row.GetProperty(name).GetString(), Is.Not.Empty, title);
                Assert.That(row.GetProperty("ours").ValueKind, Is.EqualTo(JsonValueKind.Number), title);
                Assert.That(row.GetProperty("inside").GetBoolean() || row.GetProperty("cause").GetString().Length > 0, title);
                Assert.That(row.GetProperty("at_twice_the_substeps").ValueKind, Is.EqualTo(JsonValueKind.Number), title);
                Assert.That(row.GetProperty("change").GetDouble(), Is.LessThanOrEqualTo(ValidationRow.Converged), title);
                Assert.That(row.GetProperty("converged").GetBoolean(), title);
            }
        }

        // Its published angles beside blade elements apart from the model.
        [Test]
        public void TheMeasuredAngleOfAttack_IsThatOfTheMeasuredMotion()
        {
            List<BladeElements.Moment> blades = BladeElements.Curve(MeasuredDragonfly.Tethered, BladeElements.Point.Axis);
            double[] ours = Enumerable.Range(0, 50).Select(n => blades[n * blades.Count / 50].Attack).ToArray();

            Assert.That(DragonflyRows.Correlation(ours, MeasuredDragonfly.TetheredAttack), Is.GreaterThan(0.9));
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

        // The body is held still; one that bobs has no converged trim in this climb.
        [Test]
        public void AClimbingTrim_HardlyDependsOnTheSubsteps()
        {
            TrimState trim = FreeMonarch.Climb(16, null, (0, 0), out _);

            Assert.That(180 / Math.PI * trim.Pitch, Is.EqualTo(41.3).Within(5).Percent, "the page's at 240 substeps");
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
            var row = new ValidationRow("", 1, 2, "", "", 1.5, 2.25, "");

            Assert.That((row.IsInside, row.Distance), Is.EqualTo((false, 0.25)));
            Assert.That(row.Change, Is.EqualTo(1.0 / 3).Within(1e-9));
            Assert.That(row with { Fine = double.NaN }, Has.Property(nameof(ValidationRow.IsInside)).True);
        }

        [Test]
        public void ThePage_HasTheRowsOutsideFirst_WithTheirCauses()
        {
            var rows = new List<ValidationRow> { new("good", 1, 2, "1 to 2", "s", 1.5, 1.5, "unseen"),
                new("bad", 1, 2, "1 to 2", "s", 3, 3, "because") };

            string page = ValidationPage.Markdown(rows, s_Curves, "p.svg");

            Assert.That(
                page.IndexOf("| bad |", StringComparison.Ordinal), Is.InRange(0, page.IndexOf("| good |", StringComparison.Ordinal)));
            Assert.That(
                page, Does.Contain("outside by 1.00").And.Contain("because").And.Not.Contain("unseen").And.Contain("1 of 2 rows agree"));
            Assert.That(JsonDocument.Parse(ValidationPage.Json(rows, s_Curves)).RootElement.GetProperty("rows")[1].GetProperty("distance")
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
            Assert.That(DragonflyRows.Correlation([1, 2, 3, 50], [2, 4, 6, double.NaN]), Is.EqualTo(1).Within(1e-9));
            Assert.That(JsonDocument.Parse(ValidationPage.Json([], curves)).RootElement.GetProperty("curves")[0]
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

        private static ValidationRow Row(JsonElement row) => new(
            row.GetProperty("title").GetString(), Number(row, "low", double.NegativeInfinity), Number(row, "high", double.PositiveInfinity),
            row.GetProperty("measured").GetString(),
            row.GetProperty("source").GetString(), Number(row, "ours", double.NaN), Number(row, "at_twice_the_substeps", double.NaN),
            row.GetProperty("cause").GetString());

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
