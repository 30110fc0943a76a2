using System;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Bodies that cannot fly are refused with one line that says what is wrong and what is allowed.</summary>
    public sealed class BadBodies
    {
        private static readonly BodyEllipsoid s_Thorax = BodyEllipsoid.Millimetres(0, 0, 0, 2, 2, 4, 1);

        private FlyingInsect m_Insect;

        [OneTimeSetUp]
        public void MakeTheInsect() => m_Insect = new FlyingInsect("monarch");

        [OneTimeTearDown]
        public void DisposeTheInsect() => m_Insect.Dispose();

        [Test]
        public void NoWings_AreNamed([Values] bool isNull) =>
            Assert.That(Refusal(isNull ? null : [], [s_Thorax], 1e-3f),
                Does.Contain("without wings cannot fly").And.Contain("at least one right and one left wing"));

        [Test]
        public void NoParts_AreNamed() =>
            Assert.That(Refusal(m_Insect.Model.Wings, [], 1e-3f), Does.Contain("at least one part with mass"));

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(1e-6f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void AMassBelowThatOfTheWings_IsNamed(float mass) =>
            Assert.That(
                Refusal(m_Insect.Model.Wings, [s_Thorax], mass), Does.Contain($"mass is {mass} kg").And.Contain("above that of its wings"));

        [TestCase(0, 1)]
        [TestCase(2, -1)]
        [TestCase(double.NaN, 1)]
        [TestCase(2, double.NaN)]
        public void AnImpossiblePart_IsNamed(double halfAxis, double share) =>
            Assert.That(Refusal(m_Insect.Model.Wings, [BodyEllipsoid.Millimetres(0, 0, 0, halfAxis, 2, 4, share)], 1e-3f),
                Does.Contain("half axes above 0 and a share of at least 0"));

        [Test]
        public void PartsWithoutMass_AreNamed() => Assert.That(
            Refusal(m_Insect.Model.Wings, [BodyEllipsoid.Millimetres(0, 0, 0, 2, 2, 4, 0)], 1e-3f), Does.Contain("have no mass"));

        [TestCase(46f, 0f, "swings by 46°, lowest at 0°; allowed are 0 to 45°")]
        [TestCase(-1f, 0f, "swings by -1°")]
        [TestCase(float.NaN, 0f, "swings by NaN°")]
        [TestCase(10f, float.PositiveInfinity, "any finite phase")]
        public void AnImpossibleSwing_IsNamed(float swing, float lowest, string said) => Assert.That(
            Refusal(m_Insect.Model.Wings, [s_Thorax, s_Thorax.Swinging(swing, lowest)], 1e-3f), Does.Contain(said));

        [Test]
        public void TwoPartsThatSwing_AreNamed() => Assert.That(
            Refusal(m_Insect.Model.Wings, [s_Thorax, s_Thorax.Swinging(10f, 0f), s_Thorax.Swinging(5f, 0f)], 1e-3f),
            Does.Contain("2 parts of the body swing; only the abdomen can"));

        private static string Refusal(IReadOnlyList<FlightWing> wings, IReadOnlyList<BodyEllipsoid> parts, float mass)
        {
            string line = Assert.Throws<ArgumentException>(() => new FlightModel(wings, parts, mass, 1.2f).Dispose()).Message;
            Assert.That(line, Does.Not.Contain("\n"));
            return line;
        }
    }
}
