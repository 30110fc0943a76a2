using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that are too far away to see beat: how they come to rest, and where their beat is when they wake.</summary>
    public sealed class RestLaws : FlockFixture
    {
        // Amplitudes of 0 have died away after five beats, on the insect's own clock; the beat goes on meanwhile.
        [UnityTest]
        public IEnumerator AWingComesToRest_AfterFiveBeats_AndWakesWhereItWouldBe()
        {
            InsectWings insect = Hatch();
            yield return Frames(3);
            LiveInsect live = insect.Live;
            WingWorld world = WingSystem.Loop.World;
            var clocks = new Clocks();
            float frequency = world.Read(live.wings[0].handle).Frequency;
            const double start = 100.0;

            Assert.That(Paced(start, WingDetail.Frozen), Is.EqualTo(WingDetail.WavesOnly));
            Assert.That(Paced(start + 4.9 / frequency, WingDetail.Frozen), Is.EqualTo(WingDetail.WavesOnly));
            Assert.That(Paced(start + 5.1 / frequency, WingDetail.Full), Is.EqualTo(WingDetail.Full), "seen in time");
            Assert.That(Paced(start + 7.0 / frequency, WingDetail.Frozen), Is.EqualTo(WingDetail.WavesOnly), "counted anew");
            Assert.That(Paced(start + 11.9 / frequency, WingDetail.Frozen), Is.EqualTo(WingDetail.WavesOnly));
            double asleep = start + 12.1 / frequency;
            Assert.That(Paced(asleep, WingDetail.Frozen), Is.EqualTo(WingDetail.Frozen));
            Assert.That(Paced(asleep + 1.0 / frequency, WingDetail.Frozen), Is.EqualTo(WingDetail.Frozen));
            float beats = Beats(insect);
            Assert.That(Paced(asleep + 3.25 / frequency, WingDetail.FewerSubsteps), Is.EqualTo(WingDetail.FewerSubsteps));
            Assert.That(Beats(insect) - beats, Is.EqualTo(3.25f).Within(1e-3f), "as if it had beaten on");

            Assert.That(Paced(asleep + 4.0 / frequency, WingDetail.Full, true), Is.EqualTo(WingDetail.Frozen), "out of sight at once");
            beats = Beats(insect);
            Assert.That(Paced(asleep + 6.5 / frequency, WingDetail.Full), Is.EqualTo(WingDetail.Full));
            Assert.That(Beats(insect) - beats, Is.EqualTo(2.5f).Within(1e-3f));

            WingDetail Paced(double time, WingDetail wanted, bool outOfSight = false)
            {
                clocks.times[live.Clock].time = time;
                live.Pace(world, wanted, outOfSight, clocks);
                return live.Detail;
            }
        }

        // Another clock has another time: what has rested or slept so long still has.
        [UnityTest]
        public IEnumerator OnAnotherClock_AWingHasRestedAsLong()
        {
            InsectWings insect = Hatch();
            yield return Frames(3);
            LiveInsect live = insect.Live;
            WingWorld world = WingSystem.Loop.World;
            var clocks = new Clocks();
            float frequency = world.Read(live.wings[0].handle).Frequency;
            WingUpdateMode first = insect.UpdateMode;
            WingUpdateMode other = first == WingUpdateMode.Update ? WingUpdateMode.UnscaledTime : WingUpdateMode.Update;
            clocks.times[first].time = 50.0;
            clocks.times[other].time = 1000.0;
            live.Pace(world, WingDetail.Frozen, false, clocks);
            clocks.times[first].time += 3.0 / frequency;
            insect.UpdateMode = other;
            live.Pace(world, WingDetail.Frozen, false, clocks);
            clocks.times[other].time += 1.9 / frequency;
            live.Pace(world, WingDetail.Frozen, false, clocks);
            Assert.That(live.Detail, Is.EqualTo(WingDetail.WavesOnly));
            clocks.times[other].time += 0.2 / frequency;
            live.Pace(world, WingDetail.Frozen, false, clocks);
            Assert.That(live.Detail, Is.EqualTo(WingDetail.Frozen));

            clocks.times[other].time += 1.0 / frequency;
            clocks.times[first].time = 7.0;
            float beats = Beats(insect);
            insect.UpdateMode = first;
            live.Pace(world, WingDetail.Full, false, clocks);
            Assert.That(Beats(insect) - beats, Is.EqualTo(1f).Within(1e-3f));
        }

        // The phase of the start is a share of a beat; no beat is counted before it.
        [UnityTest]
        public IEnumerator AnInsect_StartsAtItsPhase([Values(0f, 90f, 270f)] float degrees)
        {
            InsectWings insect = Hatch(made =>
            {
                made.StartPhase = degrees;
                made.UpdateMode = WingUpdateMode.Manual;
            });
            yield return Frames(2);
            for (int wing = 0; wing < 2; wing++)
                Assert.That(math.degrees(insect.Read(wing).Phase), Is.EqualTo(degrees).Within(1e-2f));
            insect.Step(0.4f / insect.Read(0).Frequency);
            insect.ResetState();
            Assert.That(math.degrees(insect.Read(0).Phase), Is.EqualTo(degrees).Within(1e-2f));
            Assert.That(insect.Live.beats, Is.EqualTo(insect.Read(0).Beats));
        }
    }
}
