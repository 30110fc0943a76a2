using System.Linq;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Veins of known widths on a flying monarch.</summary>
    public sealed class VeinTests
    {
        // Each curve is the beat's, from the top of the stroke, and its end is its beginning.
        [Test]
        public void TheFigure_HasTwistInDegreesAndCamberInPerCent_OfEachWing()
        {
            var svg = System.Xml.Linq.XElement.Parse(VeinFigure.Draw());
            System.Xml.Linq.XNamespace space = "http://www.w3.org/2000/svg";
            System.Xml.Linq.XElement[] paths = svg.Elements(space + "path").Where(path => path.Attribute("clip-path") != null).ToArray();
            RecordedWing[] wings = VeinFigure.Wings.Select(wing => VeinFigure.Fly(wing.Widths, 100)).ToArray();
            Assert.That(paths, Has.Length.EqualTo(6));
            for (int chart = 0; chart < 2; chart++)
            {
                double[][] values = wings.Select(wing => wing.Beat.OrderBy(frame =>
                    (int)System.Math.Round(50 * frame.Phase / System.Math.PI) % 100)
                    .Select(frame => chart == 0 ? 180 / System.Math.PI * wing.Measurement.Twist(frame.Positions)
                        : 100.0 * wing.Measurement.Camber(frame.Positions)).ToArray()).ToArray();
                var up = ChartAxis.Linear(values.SelectMany(own => own));
                for (int k = 0; k < 3; k++)
                {
                    double[] drawn = System.Text.RegularExpressions.Regex.Matches((string)paths[3 * chart + k].Attribute("d"),
                        @"-?\d+(\.\d+)?")
                        .Select(number => double.Parse(number.Value, System.Globalization.CultureInfo.InvariantCulture)).ToArray();
                    Assert.That(drawn, Has.Length.EqualTo(2 * 101));
                    for (int n = 0; n <= 100; n++)
                    {
                        Assert.That(drawn[2 * n], Is.EqualTo(56.0 + 490.0 * chart + 422.0 * n / 100).Within(0.06));
                        double share = (values[k][n % 100] - up.From) / (up.To - up.From);
                        Assert.That(drawn[2 * n + 1], Is.EqualTo(332.0 - 190.0 * share).Within(0.15));
                    }
                }
            }

            Assert.That(svg.Elements(space + "text").Select(text => text.Value), Is.SupersetOf(
                VeinFigure.Wings.Select(wing => wing.Name).Append("twist, °").Append("camber, % of the chord")));
            Assert.That((string)svg.Attribute("viewBox"), Is.EqualTo("0 0 1000 366"));
        }

        [Test]
        public void ThickVeinsInFront_LetTheTrailingEdgeLag_AndThickOnesBehindHoldIt()
        {
            WingSummary[] wings = VeinFigure.Wings.Select(wing => WingSummary.Of(VeinFigure.Fly(wing.Widths, 16))).ToArray();
            (WingSummary alike, WingSummary front, WingSummary behind) = (wings[0], wings[1], wings[2]);

            Assert.That(front.LagDeg, Is.GreaterThan(alike.LagDeg + 2), "measured wings have a stiff leading and a soft trailing edge");
            Assert.That(behind.LagDeg, Is.LessThan(alike.LagDeg - 4));
            Assert.That(front.TwistPpDeg, Is.GreaterThan(1.1 * alike.TwistPpDeg));
            Assert.That(behind.TwistPpDeg, Is.LessThan(0.9 * alike.TwistPpDeg));
            Assert.That(front.CamberMaxPct - front.CamberMinPct, Is.GreaterThan(1.05 * (alike.CamberMaxPct - alike.CamberMinPct)));
            Assert.That(front.TipBendPpDeg, Is.LessThan(alike.TipBendPpDeg), "the leading edge bends less");
        }
    }
}
