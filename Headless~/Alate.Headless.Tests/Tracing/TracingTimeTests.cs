using System;
using System.Diagnostics;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class TracingTimeTests
    {
        private const double k_Bound = 2.0;

        [Test]
        public void PictureOfTwoThousandPixels_IsTracedInTwoSecondsOfProcessorTime()
        {
            WingPicture small = new DrawnVeinPicture(DrawnWing.Monarch(), 200, 6, VeinLook.Photo).Picture.ToPicture();
            WingPicture large = new DrawnVeinPicture(DrawnWing.Monarch(), 2000, 6, VeinLook.Photo).Picture.ToPicture();
            WingTracer.Trace(small, WingTracingSettings.Default);

            TimeSpan before = Process.GetCurrentProcess().TotalProcessorTime;
            WingTracer.Trace(large, WingTracingSettings.Default);
            double taken = (Process.GetCurrentProcess().TotalProcessorTime - before).TotalSeconds;

            TestContext.Out.WriteLine($"{taken:F2} s");
            Assert.That(taken, Is.LessThan(k_Bound));
        }
    }
}
