using System;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using StandIns;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Places at which a table gets points, with trims that lie on a plane over speed and climb in place of flights.</summary>
    public sealed class TableRefinementLaws
    {
        private const float k_Frequency = 10f;

        [Test]
        public void WhereSpeedsDoNotMix_TheirMiddlesComeIn_UntilTheyDo()
        {
            using TrimTable refined = Refine(
                Table([0f, 0.4f, 0.5f], [-0.2f, 0f, 0.3f]), (table, at) => Gap(table.Speeds, at.Speed) < 0.11f, Copied);

            Assert.That(refined.Speeds, Is.EqualTo(new[] { 0f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f }).Within(1e-6f));
            Assert.That(refined.ClimbRates, Is.EqualTo(new[] { -0.2f, 0f, 0.3f }));
            AllLieOnThePlane(refined);
        }

        // One climb alone that does not mix is enough, and one without a trim on a side says nothing.
        [TestCase(true)]
        [TestCase(false)]
        public void OneClimbThatDoesNotMix_AddsASpeed_IfBothItsTrimsClose(bool closes)
        {
            TrimTable table = Table([0f, 0.2f], [-0.2f, 0f, 0.3f]);
            if (!closes)
                table.Open(1, 2);
            using TrimTable refined = Refine(table, (_, at) => at.Climb < 0.2f, (_, near) => closes ? near : null);

            Assert.That(refined.Speeds, Has.Length.EqualTo(closes ? 5 : 2));
        }

        // Halves of 50 mm are left, and climbs that are nearer than 140 mm/s; each pair of climbs is tried once.
        [Test]
        public void WhereNothingMixes_SpeedsEndAtAFewCentimetres_AndClimbsAtMoreThanADecimetre()
        {
            using TrimTable refined = Refine(Table([0f, 0.4f], [-0.2f, 0f, 0.3f, 0.43f]), (_, _) => false, Copied);

            Assert.That(refined.Speeds, Is.EqualTo(Enumerable.Range(0, 9).Select(k => 0.05f * k)).Within(1e-6f));
            Assert.That(refined.ClimbRates, Is.EqualTo(new[] { -0.2f, -0.1f, 0f, 0.15f, 0.225f, 0.3f, 0.43f }).Within(1e-6f));
            AllLieOnThePlane(refined);
        }

        [Test]
        public void WhereNoLevelTrimCloses_TheTableStays()
        {
            TrimTable table = Table([0f, 0.4f], [-0.1f, 0f]);
            Assert.That(Refine(table, (_, _) => false, (_, _) => null), Is.SameAs(table));
        }

        // From level outwards: beyond a climb that does not close none is tried, as nobody flies there.
        [Test]
        public void AnAddedSpeed_HasTheClimbsThatItsTrimsReach()
        {
            using TrimTable refined = Refine(
                Table([0f, 0.1f], [-0.4f, -0.2f, 0f, 0.2f, 0.4f]), (table, at) => Gap(table.Speeds, at.Speed) < 0.06f,
                (at, near) => at.Speed == 0.05f && Math.Abs(at.Climb - 0.2f) < 1e-6f ? null : near);

            Assert.That(refined.Speeds, Has.Length.EqualTo(3));
            Assert.That(Enumerable.Range(0, 5).Select(c => refined.IsClosed(1, c)), Is.EqualTo(new[] { true, true, true, false, false }));
        }

        // A hole is filled from the climb nearer to level and the speed beside it, and opened again where its trim does not mix with them.
        [TestCase(0, 0, true)]
        [TestCase(1, 3, true)]
        [TestCase(2, 0, true)]
        [TestCase(2, 3, false)]
        [TestCase(0, 3, false)]
        public void AHoleAtTheEnd_IsFilled_IfItMixes(int s, int c, bool mixes)
        {
            TrimTable table = Table([0f, 0.2f, 0.4f], [-0.3f, 0f, 0.3f, 0.5f]);
            float[] before = table.Point(s, c);
            table.Open(s, c);
            int beside = s < 2 ? s + 1 : s - 1, inner = c == 0 ? 1 : c - 1;
            using TrimTable refined = Refine(
                table, (of, at) => mixes || !of.IsClosed(s, c) || at.Climb != of.ClimbRates[c], Copied);

            Assert.That(refined, Is.SameAs(table));
            Assert.That(refined.IsClosed(s, c), Is.EqualTo(mixes));
            if (!mixes)
                return;
            double pitch = TrimState.Read(refined.Point(s, c), k_Frequency).Pitch;
            Assert.That(pitch, Is.EqualTo(0.5 * (PitchAt(table.Speeds[s], table.ClimbRates[inner])
                + PitchAt(table.Speeds[beside], table.ClimbRates[c]))).Within(1e-6));
            Assert.That(refined.Point(s, c), Is.Not.SameAs(before));
        }

        // Whoever waits for a bake may stop it at any table that is flown: the one that was given, or one in its place.
        [TestCase(1)]
        [TestCase(4)]
        [TestCase(9)]
        public void StoppedAtAnyFlight_ItLeavesNoMemory(int flights)
        {
            int live = NativeMemoryLedger.LiveCount, flown = 0;
            TrimTable table = Table([0f, 0.4f], [-0.2f, 0f, 0.3f]);

            Assert.That(() => Refine(table, (of, at) =>
            {
                // A flight reads the table from memory of its own.
                TrimTableView read = of.View;
                Assert.That((read.speedCount, NativeMemoryLedger.LiveCount > live), Is.EqualTo((of.Speeds.Length, true)));
                return ++flown == flights ? throw new InvalidOperationException("stopped") : false;
            }, Copied), Throws.InvalidOperationException);
            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(live), NativeMemoryLedger.Describe());
        }

        private static TrimState Copied(FlightCondition at, TrimState near) => near;

        private static TrimTable Refine(
            TrimTable table, Func<TrimTable, FlightCondition, bool> mixes, Func<FlightCondition, TrimState, TrimState> solve) =>
            new TableRefinement(k_Frequency, solve, mixes, (to, s, c, trim) => to.Set(s, c, Point(trim))).Refine(table);

        private static double PitchAt(float speed, float climb) => 0.7 - 0.5 * speed + 0.25 * climb;

        private static TrimTable Table(float[] speeds, float[] climbs)
        {
            var table = new TrimTable(speeds, climbs);
            for (int s = 0; s < speeds.Length; s++)
            {
                for (int c = 0; c < climbs.Length; c++)
                {
                    var trim = new TrimState();
                    trim.z[0] = PitchAt(speeds[s], climbs[c]);
                    trim.z[1] = 1 + 0.1 * speeds[s];
                    trim.bob[3] = 0.2 * speeds[s] - 0.1 * climbs[c];
                    table.Set(s, c, Point(trim));
                }
            }

            return table;
        }

        private static float[] Point(TrimState trim)
        {
            float[] point = new float[TrimPoint.Floats];
            trim.Write(point, k_Frequency);
            return point;
        }

        // Distance of the points around a speed; none at a point.
        private static float Gap(float[] axis, float at)
        {
            int next = Array.FindIndex(axis, value => value >= at);
            return axis[next] == at ? 0f : axis[next] - axis[next - 1];
        }

        private static void AllLieOnThePlane(TrimTable table)
        {
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                for (int c = 0; c < table.ClimbRates.Length; c++)
                {
                    Assert.That(table.IsClosed(s, c), $"{table.Speeds[s]} m/s, {table.ClimbRates[c]} m/s");
                    var trim = TrimState.Read(table.Point(s, c), k_Frequency);
                    Assert.That(trim.Pitch, Is.EqualTo(PitchAt(table.Speeds[s], table.ClimbRates[c])).Within(1e-6));
                    Assert.That(trim.FrequencyScale, Is.EqualTo(1 + 0.1 * table.Speeds[s]).Within(1e-6));
                    Assert.That(trim.bob[3], Is.EqualTo(0.2 * table.Speeds[s] - 0.1 * table.ClimbRates[c]).Within(1e-6));
                }
            }
        }
    }
}
