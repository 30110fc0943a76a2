using System.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Veins of known widths on a flying monarch.</summary>
    public sealed class VeinTests
    {
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
