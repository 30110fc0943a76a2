using System;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class ClockTimesTests
    {
        [Test]
        public void EveryUpdateMode_HasAClockOfItsOwn()
        {
            var modes = (WingUpdateMode[])Enum.GetValues(typeof(WingUpdateMode));
            var times = new ClockTimes();
            foreach (WingUpdateMode mode in modes)
                times[mode].count = 1 + (int)mode;

            Assert.That(ClockTimes.Count, Is.EqualTo(modes.Length));
            foreach (WingUpdateMode mode in modes)
                Assert.That(times[mode].count, Is.EqualTo(1 + (int)mode));
        }

        [TestCase(true, 1, 0.1f, true)]
        [TestCase(false, 1, 0.1f, false)]
        [TestCase(true, 0, 0.1f, false)]
        [TestCase(true, 1, 0f, false)]
        public void Wings_AreSteppedOnlyWhereAClockInUse_HasStepsWithALength(bool inUse, int count, float length, bool due)
        {
            var times = new ClockTimes();
            times[WingUpdateMode.UnscaledTime] = new ClockTime { inUse = inUse, count = count, length = length };

            Assert.That(times.AnyDue(), Is.EqualTo(due));
            Assert.That(times.AnyDrawn(), Is.False);
        }
    }
}
