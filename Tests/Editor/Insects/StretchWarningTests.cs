using NUnit.Framework;

namespace Alate.Editor.Tests
{
    public sealed class StretchWarningTests
    {
        [Test]
        public void ABearableStretch_IsNoWarning() => Assert.That(LiveNumbers.Overstretched(0.1f), Is.Null);

        [Test]
        public void MoreStretchThanAWingBears_IsOneLine_WithItsValueAndWhatToChange()
        {
            string warning = LiveNumbers.Overstretched(0.234f);

            Assert.That(warning, Does.Contain("23 %").And.Contain("Lower the wind").And.Contain("Elasticity").And
                .Contain("Coupling").And.Not.Contain("\n"));
        }

        [Test]
        public void TheLargestStretchOfABeat_IsShown_UntilAnotherBeatHasPassed()
        {
            var peak = new RecentPeak();
            Assert.That(peak.Value, Is.Zero);
            Assert.That(After(ref peak, 3.0, 0.2f), Is.EqualTo(0.2f));
            Assert.That(After(ref peak, 3.9, 0.05f), Is.EqualTo(0.2f), "within a beat");
            Assert.That(After(ref peak, 3.95, 0.3f), Is.EqualTo(0.3f), "a larger one");
            Assert.That(After(ref peak, 5.0, 0.04f), Is.EqualTo(0.04f), "after more than a beat");
            Assert.That(After(ref peak, 0.1, 0.01f), Is.EqualTo(0.01f), "of a wing that has started over");
        }

        [Test]
        public void AValueThatIsNoNumber_DoesNotHideTheLargest_AndTextsArePerCent()
        {
            var peak = new RecentPeak();
            After(ref peak, 3.0, 0.2f);
            Assert.That(After(ref peak, 3.5, float.NaN), Is.EqualTo(0.2f));
            Assert.That(After(ref peak, 4.0, 0.1f), Is.EqualTo(0.2f), "just a beat");
            Assert.That(LiveNumbers.Stretch(0.03f), Is.EqualTo("3 %"));
            Assert.That(LiveNumbers.Overstretched(0.101f), Is.Not.Null);
            Assert.That(LiveNumbers.Lift(default), Is.EqualTo("—"));
            Assert.That(LiveNumbers.Lift(new[] { new BeatSample(0.0, 0f, 0.666f) }), Is.EqualTo("0.67 of the weight"));
        }

        private static float After(ref RecentPeak peak, double beat, float value)
        {
            peak.Add(beat, value);
            return peak.Value;
        }
    }
}
