using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class WingNameTests
    {
        [TestCase("ForeWing_L.001", ExpectedResult = "fore left")]
        [TestCase("Wing.R", ExpectedResult = "right")]
        [TestCase("Left_wing", ExpectedResult = "left")]
        [TestCase("wing_l", ExpectedResult = "left")]
        [TestCase("wingR", ExpectedResult = "right")]
        [TestCase("wingl", ExpectedResult = "left")]
        [TestCase("lwing", ExpectedResult = "left")]
        [TestCase("hindwingleft", ExpectedResult = "hind left")]
        [TestCase("FRONTWINGRIGHT", ExpectedResult = "fore right")]
        [TestCase("RearLeftWing", ExpectedResult = "hind left")]
        [TestCase("Wing_FR", ExpectedResult = "fore right")]
        [TestCase("wingbl", ExpectedResult = "hind left")]
        [TestCase("UpperWing-Right (1)", ExpectedResult = "fore right")]
        [TestCase("lower_wing", ExpectedResult = "hind")]
        [TestCase("Wings", ExpectedResult = "")]
        [TestCase("Wing2", ExpectedResult = "")]
        [TestCase("monarch_WING_geo", ExpectedResult = "")]
        [TestCase("Pectoral fins", ExpectedResult = "")]
        [TestCase("LWing RWing", ExpectedResult = "")]
        public string AWing_IsRead_WithItsPairAndSide(string name)
        {
            var read = WingName.Read(name);
            Assert.That(read.IsWing, Is.True);
            return $"{read.Pair} {read.Side}".Trim().ToLowerInvariant();
        }

        [TestCase("swing")]
        [TestCase("Drawing Board")]
        [TestCase("Wingman")]
        [TestCase("winged insect")]
        [TestCase("Growing_l")]
        [TestCase("finger.L")]
        [TestCase("Final")]
        [TestCase("Dolphin")]
        [TestCase("elytra_L")]
        [TestCase("Elytron.R")]
        [TestCase("wingcase")]
        [TestCase("WingCover_Left")]
        [TestCase("Wing Shell")]
        [TestCase("body and wings")]
        [TestCase("WingHinge_L")]
        [TestCase("wing collider")]
        [TestCase("TailFin")]
        [TestCase("all")]
        [TestCase("001")]
        [TestCase("")]
        [TestCase(null)]
        public void WhatIsNoWing_IsNotReadAsOne(string name)
        {
            Assert.That(WingName.Read(name).IsWing, Is.False);
        }

        [Test]
        public void ACase_IsTold_AndWingsWithTheirBodyToo()
        {
            Assert.That(WingName.Read("elytra_L").IsCase);
            Assert.That(WingName.Read("BodyAndWings").NamesWing);
            Assert.That(WingName.Read("Wing.L Mesh").IsPlainWing);
            Assert.That(WingName.Read("Monarch Wing").IsPlainWing, Is.False);
        }
    }
}
