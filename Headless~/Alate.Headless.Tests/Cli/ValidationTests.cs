using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Alate.Cli;
using Alate.Cli.Validation;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Comparisons with published flights.</summary>
    public sealed class ValidationTests
    {
        private static readonly ValidationCurve[] s_Curves = [new("twist", "twist", [("flexible", [0.0, 1.0, 0.0, -1.0])], null), new("camber", "camber", [("flexible", [0.0, 0.0, 0.0, 0.0])], null)];

        // An estimate by others: 20 strips, uniform chord, no twist, the stream on the axis.
        [TestCase(0, 1.10)]
        [TestCase(1, 0.99)]
        [TestCase(2, 1.11)]
        public void BladeElements_GiveTheIndependentEstimate(int flight, double lift) =>
            Assert.That(BladeElements.Lift(MeasuredDragonfly.Flights[flight], BladeElements.Point.Axis), Is.EqualTo(lift).Within(0.01));

        [Test]
        public void TheInducedFlow_IsThatOfMomentumTheory() => Assert.That(DragonflyRows.Induced(), Is.EqualTo(0.93).Within(0.03));

        [Test]
        public void ATetheredDragonfly_PullsAsItWasComputed_WithAWakeFactor()
        {
            var run = DragonflyRun.Fly(MeasuredDragonfly.Tethered, true, 48, 1.2 * DragonflyRows.Induced());
            double[] ours = run.Even(run.Lift, 50);

            Assert.That(DragonflyRows.Correlation(ours, MeasuredDragonfly.TetheredForce), Is.GreaterThan(0.9));
            Assert.That(ours.Average(), Is.EqualTo(MeasuredDragonfly.TetheredForce.Average()).Within(30).Percent);
            Assert.That(ours.Max(), Is.EqualTo(MeasuredDragonfly.TetheredForce.Max()).Within(30).Percent);
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
            var rows = new List<ValidationRow> { new("good", 1, 2, "1 to 2", "s", 1.5, 1.5, "unseen"), new("bad", 1, 2, "1 to 2", "s", 3, 3, "because") };

            string page = ValidationPage.Markdown(rows, "p.svg");

            Assert.That(page.IndexOf("| bad |", StringComparison.Ordinal), Is.InRange(0, page.IndexOf("| good |", StringComparison.Ordinal)));
            Assert.That(page, Does.Contain("outside by 1.00").And.Contain("because").And.Not.Contain("unseen").And.Contain("1 of 2 rows agree"));
            Assert.That(JsonDocument.Parse(ValidationPage.Json(rows, s_Curves)).RootElement.GetProperty("rows")[1].GetProperty("distance").GetDouble(), Is.EqualTo(1));
        }

        [Test]
        public void AUsersCurve_IsReadBetweenItsRows_AndGetsARow()
        {
            using var run = new CommandRun();
            run.Write("twist.csv", "t/T,twist\n0,0\n0.25,2\n0.5,0\n0.75,-2\n");

            List<ValidationCurve> curves = UserCurves.Read(run.Folder, s_Curves);

            Assert.That(curves[0].Measured, Is.EqualTo(new[] { 0.0, 2, 0, -2 }));
            Assert.That(curves[1].Measured, Is.Null);
            Assert.That(UserCurves.Rows(curves).Single().Ours, Is.EqualTo(1).Within(1e-9));
        }

        [TestCase("lift.csv", "0,1", "there is no such curve. Known: twist.csv, camber.csv.")]
        [TestCase("twist.csv", "0,1\n0.5,1\n", "it has 2 rows; a beat needs at least three.")]
        [TestCase("twist.csv", "0,1\n0.5,x\n", "line 2: '0.5,x' is not t/T and a value.")]
        [TestCase("twist.csv", "0,1\n0.5\n", "line 2: '0.5' is not t/T and a value.")]
        [TestCase("twist.csv", "0,1\n0.5,2\n0.4,3\n", "line 3: 0.4 is not after the row before it and between 0 and 1.")]
        public void ABadCurve_IsOneLine(string name, string text, string message)
        {
            using var run = new CommandRun();
            string path = run.Write(name, text);

            Assert.That(() => UserCurves.Read(run.Folder, s_Curves), Throws.TypeOf<UserException>().With.Message.EqualTo($"{path}: {message}"));
        }

        [Test]
        public void AFolderThatIsNotThere_OrIsEmpty_IsRefused()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("validate", "--data", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("there is no such folder"));
            Assert.That(() => UserCurves.Read(run.Folder, s_Curves), Throws.TypeOf<UserException>().With.Message.Contains("has no CSV file"));
        }
    }
}
