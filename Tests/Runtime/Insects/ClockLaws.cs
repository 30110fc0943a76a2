using System.Collections.Generic;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Clocks of the wings: steps of a length, as many as the time has, and none lost.</summary>
    public sealed class ClockLaws
    {
        private static readonly List<LiveInsect> s_None = new List<LiveInsect>();

        [Test]
        public void EachClock_HasTheTimeOfItsSteps([Values(0.004f, 0.05f, 0.1f)] float dt)
        {
            var clocks = new Clocks();
            double told = 0.0, unscaled = 0.0, physics = 0.0;
            for (int frame = 1; frame <= 40; frame++)
            {
                clocks.FixedStep(0.02f, s_None);
                physics += 0.02;
                Assert.That(clocks.times[WingUpdateMode.FixedUpdate].time, Is.EqualTo(physics).Within(1e-6));
                Assert.That(clocks.times[WingUpdateMode.Update].count, Is.Zero, "each is due in its own turn");
                clocks.Frame(dt, 2f * dt, s_None);
                ClockTime update = clocks.times[WingUpdateMode.Update], real = clocks.times[WingUpdateMode.UnscaledTime];
                told += update.count * (double)update.length;
                unscaled += real.count * (double)real.length;
                Assert.That(update.length, Is.EqualTo(1f / 60f));
                Assert.That(update.time, Is.EqualTo(told).Within(1e-9));
                Assert.That(real.time, Is.EqualTo(unscaled).Within(1e-9));
                Assert.That(update.time, Is.EqualTo(frame * dt).Within(1.0 / 60.0 + 1e-4), $"frame {frame}");
                Assert.That(real.time, Is.EqualTo(2.0 * frame * dt).Within(1.0 / 60.0 + 1e-4));
                Assert.That(clocks.times[WingUpdateMode.FixedUpdate].count, Is.Zero);
                Assert.That(clocks.times[WingUpdateMode.Manual].time, Is.Zero);
            }
        }

        [Test]
        public void WhatMoved_IsDrawn_UntilNobodyUsesItsClock()
        {
            var clocks = new Clocks();
            Assert.That(clocks.times[WingUpdateMode.Update].moved, Is.False);
            clocks.MoveAll();
            for (int clock = 0; clock < ClockTimes.Count; clock++)
                Assert.That(clocks.times[clock].moved, $"clock {clock}");
            clocks.times[1].inUse = true;
            clocks.EndDrawing();
            for (int clock = 0; clock < ClockTimes.Count; clock++)
                Assert.That(clocks.times[clock].moved, Is.EqualTo(clock != 1), "what nobody draws has still moved");
        }

        // A quarter of a second; of what is beyond it, one step is made up for later.
        [Test]
        public void AHitch_IsFifteenSteps()
        {
            var clocks = new Clocks();
            clocks.Frame(1f, 7f, s_None);
            Assert.That(clocks.times[WingUpdateMode.Update].count, Is.EqualTo(15));
            Assert.That(clocks.times[WingUpdateMode.UnscaledTime].count, Is.EqualTo(15));
            clocks.Frame(0f, 0f, s_None);
            Assert.That(clocks.times[WingUpdateMode.Update].count, Is.Zero);
            clocks.Frame(1f / 60f, 2f / 60f, s_None);
            Assert.That(clocks.times[WingUpdateMode.Update].count, Is.EqualTo(2));
            Assert.That(clocks.times[WingUpdateMode.UnscaledTime].count, Is.EqualTo(3));
        }

        [TestCase(WingUpdateMode.FixedUpdate, true, false)]
        [TestCase(WingUpdateMode.Update, false, true)]
        [TestCase(WingUpdateMode.UnscaledTime, false, true)]
        [TestCase(WingUpdateMode.Manual, false, false)]
        public void AClock_AdvancesWithPhysicsOrWithFrames(WingUpdateMode clock, bool physics, bool frames) =>
            Assert.That((Clocks.Advances(true, clock), Clocks.Advances(false, clock)), Is.EqualTo((physics, frames)));
    }
}
