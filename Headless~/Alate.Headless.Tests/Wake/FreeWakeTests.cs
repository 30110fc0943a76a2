using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using MathNet.Numerics.LinearAlgebra;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Wake
{
    /// <summary>Free wakes as a whole: bounds, conservation, memory and messages.</summary>
    public sealed class FreeWakeTests
    {
        // Plate that claps against its mirror image: hinged at a gap from the plane of symmetry, from level to upright and back.
        private sealed class Clapping : IWingMotion
        {
            public float Gap { get; init; }

            public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
            {
                double angle = 0.25 * Math.PI * (1.0 - Math.Cos(2.0 * Math.PI * beats));
                double rate = 0.5 * Math.PI * Math.PI * Math.Sin(2.0 * Math.PI * beats);
                float cos = (float)Math.Cos(angle), sin = (float)Math.Sin(angle);
                for (int k = 0; k < places.Length; k++)
                {
                    points[k] = new float3(0.5f * Gap + places[k].y * cos, places[k].y * sin, 1.5f - 3f * places[k].x);
                    velocities[k] = (float)rate * places[k].y * new float3(-sin, cos, 0f);
                }
            }
        }

        [Test]
        public void WingsThatClap_StayBounded([Values] WakeMethod method, [Values(0.02f, 0f)] float gap)
        {
            var settings = new WakeSettings(method) { Symmetric = true, SpanPanels = 6, Stream = new float3(0f, 0f, -1f) };
            using var wake = new FreeWake(settings, new[] { new WakeWing(new Clapping { Gap = gap }) });
            for (int k = 0; k < 72; k++)
            {
                wake.Step();
                float largest = wake.Wings[0].Lattice.Circulation.Max(math.abs);
                // A few times the chord and the speed of the tip, 3 · π²/2.
                Assert.That(largest, Is.LessThan(20f));
                Assert.That(math.all(math.isfinite(wake.Loads(0).Force)), Is.True);
            }
        }

        // The settings are taken as they are when the wake is made.
        [Test]
        public void SettingsThatChangeLater_DoNothing([Values] WakeMethod method)
        {
            var settings = new WakeSettings(method) { Symmetric = true, Stream = new float3(0f, 0f, -1f) };
            WakeWing[] wings = new[] { new WakeWing(new Clapping { Gap = 0.1f }) };
            using FreeWake wake = new FreeWake(settings, wings), same = new FreeWake(settings, wings);
            (settings.Stream, settings.StepsPerBeat, settings.SpanPanels) = (new float3(0f, 5f, 0f), 7, 200);
            (settings.TurnedSuction, settings.SuctionAlongChord) = (0f, true);
            wake.Step();
            wake.Step();
            (settings.Stream, settings.StepsPerBeat) = (float.NaN, 1000);
            same.Step();
            same.Step();

            Assert.That((wake.Time, wake.SectionCount), Is.EqualTo((2.0 / 24.0, 10)));
            Assert.That(math.all(math.isfinite(same.Loads(0).Force)), Is.True);
            Assert.That(wake.Loads(0).Force, Is.EqualTo(same.Loads(0).Force));
        }

        [Test]
        public void AWake_GivesBackAllMemory([Values] WakeMethod method)
        {
            int memory = NativeMemoryLedger.LiveCount;
            var settings = new WakeSettings(method) { Symmetric = true, GroundHeight = 3f, Stream = new float3(0f, 0f, -1f) };
            using (var wake = new FreeWake(settings, new[] { new WakeWing(new Clapping { Gap = 0.1f }) }))
            {
                for (int k = 0; k < 3; k++)
                    wake.Step();
            }

            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory), NativeMemoryLedger.Describe());
        }

        // A narrow strip answers to its own trailing legs by many times what it has.
        [Test]
        public void NarrowStrips_FindTheirCirculation_AndLiftAsWideOnes()
        {
            float[] lifts = Array.ConvertAll(new[] { 16, 96 }, panels =>
            {
                var settings = new WakeSettings { SpanPanels = panels, StepsPerBeat = 8, Stream = new float3(0f, 0f, -4f) };
                using var wake = new FreeWake(settings, new[] { new WakeWing(ThinWing.Steady(2f, 0.1)) });
                for (int k = 0; k < 16; k++)
                    wake.Step();
                Assert.That(wake.Failures, Is.Zero, $"{panels} strips");
                return wake.Loads(0).Force.y;
            });

            Assert.That(lifts[1], Is.EqualTo(lifts[0]).Within(5).Percent);
        }

        // In 1546 the wing folds up beside its mirror image, which gives its circulation no bound of its own.
        [Test]
        public void RandomMotions_StayFinite([Values(1, 2, 3, 4, 5, 6, 7, 8, 1546)] int seed) => AssertFinite(seed);

        [Test]
        [Explicit]
        [Category("Long")]
        public void OtherRandomMotions_StayFinite([Range(9, 24)] int seed) => AssertFinite(seed);

        [Test]
        [Explicit]
        [Category("Long")]
        public void AThousandRandomMotions_StayFinite([Range(1001, 2000)] int seed) => AssertFinite(seed);

        private static void AssertFinite(int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            var samples = new float3[16][];
            float3[] means = { new(0.1f, 0f, 0.2f), new(1f, 0f, 0.1f), new(0.1f, 0f, -0.2f), new(1f, 0f, -0.1f) };
            float3[] swings = means.Select(_ => random.NextFloat3(-0.6f, 0.6f)).ToArray();
            float3[] phases = means.Select(_ => random.NextFloat3(0f, 6f)).ToArray();
            for (int k = 0; k < samples.Length; k++)
            {
                float phase = 2f * math.PI * k / samples.Length;
                samples[k] = means.Select((mean, n) => mean + swings[n] * math.cos(phase + phases[n])).ToArray();
            }
            var settings = new WakeSettings(random.NextBool() ? WakeMethod.Panels : WakeMethod.Strips)
            {
                SpanPanels = 5,
                StepsPerBeat = 16,
                Symmetric = random.NextBool(),
                Stream = random.NextFloat3(-2f, 2f) * new float3(0f, 1f, 1f),
                GroundHeight = random.NextBool() ? 1.2f : float.PositiveInfinity,
            };
            using var wake = new FreeWake(settings, new[] { new WakeWing(FourierMotion.Through(samples, 2, 2)) });
            for (int k = 0; k < 48; k++)
                wake.Step();

            WingState wing = wake.Wings[0];
            Assert.That(math.all(math.isfinite(wing.Loads.Force)) && math.isfinite(wing.Loads.Power), Is.True);
            for (int row = 0; row < wing.Sheet.RowCount; row++)
            {
                for (int j = 0; j < wing.Sheet.Width; j++)
                    Assert.That(math.all(math.isfinite(wing.Sheet.Point(row, j))), Is.True);
            }
        }

        [Test]
        public void TheCirculationOfAWing_IsThatOfItsWakeWithTheOtherSign()
        {
            // Kelvin: rings are closed, so what a row has shed since the start adds up to what is bound.
            using var wake = new FreeWake(
                new WakeSettings(WakeMethod.Panels) { SpanPanels = 4, Stream = new float3(0f, 0f, -1f), Keep = 10f },
                new[] { new WakeWing(ThinWing.Steady(3f, 0.1)) });
            for (int k = 0; k < 30; k++)
                wake.Step();
            WingState wing = wake.Wings[0];
            // The ring behind the edge has what the edge had a step before.
            Assert.That(wing.Sheet.Circulation(1, 2), Is.EqualTo(wing.Lattice.Before[wing.Lattice.Ring(3, 2)]).Within(1e-6f).Or
                .EqualTo(wing.Lattice.LongBefore[wing.Lattice.Ring(3, 2)]).Within(1e-6f));
            Assert.That(wing.Sheet.RowCount, Is.EqualTo(30));
            WakeSheet sheet = wake.Sheet(0);
            Assert.That((sheet.RowCount, sheet.PointsPerRow), Is.EqualTo((30, 5)));
            Assert.That(sheet.Circulation(28, 3), Is.EqualTo(wing.Sheet.Circulation(28, 3)));
            Assert.That(sheet.Point(29, 4), Is.EqualTo(wing.Sheet.Point(29, 4)));
            Assert.That(sheet.Age(0), Is.Zero);
            for (int j = 0; j < 5; j++)
            {
                Assert.That(
                    sheet.Point(0, j), Is.EqualTo(wing.Lattice.Rings[wing.Lattice.Corner(4, j)]), "wing and wake are of one moment");
            }

            Assert.That(() => wake.Sheet(1), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("There are 1 wings"));
            Assert.That(() => sheet.Point(30, 0), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("There are 30"));
            Assert.That(() => sheet.Point(0, -1), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => sheet.Circulation(29, 0), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("are 29"));
            Assert.That(() => sheet.Circulation(0, 4), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("are 4"));
            Assert.That(() => sheet.Age(30), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(wing.Sheet.Age(29), Is.EqualTo(29f / 24f).Within(1e-5f));
        }

        [Test]
        public void AStep_AllocatesNothing([Values] WakeMethod method)
        {
            using var wake = new FreeWake(
                new WakeSettings(method) { SpanPanels = 5, Symmetric = true, Stream = new float3(0f, 0f, -1f) },
                new[] { new WakeWing(ThinWing.Steady(2f, 0.1)) });
            for (int k = 0; k < 4; k++)
                wake.Step();
            // The least of some steps: the runtime allocates now and then as it compiles.
            long least = long.MaxValue;
            for (int k = 0; k < 20; k++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                wake.Step();
                least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            }

            Assert.That(least, Is.Zero);
        }

        [Test]
        public void ALinearSystem_IsSolvedAsByALibrary([Range(1, 5)] int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            int size = 3 + 7 * seed;
            Matrix<double> matrix = Matrix<double>.Build.Dense(size, size, (_, _) => random.NextFloat(-1f, 1f));
            Vector<double> right = Vector<double>.Build.Dense(size, _ => random.NextFloat(-1f, 1f));
            var system = new LinearSystem(size);
            for (int row = 0; row < size; row++)
            {
                for (int column = 0; column < size; column++)
                    system.Set(row, column, matrix[row, column]);
                system.SetRight(row, right[row]);
            }

            float[] solution = new float[size];
            Assert.That(system.Solve(solution), Is.True);
            Vector<double> exact = matrix.Solve(right);
            for (int k = 0; k < size; k++)
                Assert.That(solution[k], Is.EqualTo(exact[k]).Within(1e-5 * exact.InfinityNorm()));
        }

        [Test]
        public void ASingularSystem_HasNoSolution()
        {
            var system = new LinearSystem(2);
            for (int k = 0; k < 4; k++)
                system.Set(k / 2, k % 2, 1.0);
            system.SetRight(0, 1.0);
            system.SetRight(1, 2.0);
            float[] solution = { 5f, 6f };
            Assert.That(system.Solve(solution), Is.False);
            Assert.That(solution, Is.All.Zero);
        }

        [Test]
        public void ASystemThatHoldsNoNumber_HasNoSolution(
            [Values(1, 2, 3, 4)] int size, [Values(float.NaN, float.PositiveInfinity)] float value)
        {
            for (int place = 0; place < size * size; place++)
            {
                var random = Random.CreateFromIndex((uint)place);
                var system = new LinearSystem(size);
                for (int k = 0; k < size * size; k++)
                    system.Set(k / size, k % size, k == place ? value : random.NextFloat(-1f, 1f));
                for (int row = 0; row < size; row++)
                    system.SetRight(row, 1.0);
                float[] solution = Enumerable.Repeat(5f, size).ToArray();
                Assert.That(system.Solve(solution), Is.False, $"at {place / size}, {place % size}");
                Assert.That(solution, Is.All.Zero);
            }
        }

        [TestCase("StepsPerBeat is 3; allowed: 4 to 1000.")]
        [TestCase("SpanPanels is 0; allowed: 1 to 256.")]
        [TestCase("ChordPanels is 2; allowed: 1 for strips.")]
        [TestCase("Keep is NaN; allowed: above 0, at most 1000 beats.")]
        [TestCase("FarCore is 0.1; allowed: NearCore to 10 chords.")]
        [TestCase("GroundHeight is -1; allowed: above 0.")]
        [TestCase("Viscosity is -1; allowed: at least 0.")]
        [TestCase("rings of all wings is 2560; allowed: at most 2000.")]
        [TestCase("vertices of the wake is 4112514; allowed: at most 4000000: fewer steps, panels or beats to keep.")]
        public void NumbersOutOfRange_AreNamed(string message)
        {
            var settings = new WakeSettings(message.StartsWith("rings") ? WakeMethod.Panels : WakeMethod.Strips);
            switch (message.Split(' ')[0])
            {
                case "StepsPerBeat": settings.StepsPerBeat = 3; break;
                case "SpanPanels": settings.SpanPanels = 0; break;
                case "ChordPanels": settings.ChordPanels = 2; break;
                case "Keep": settings.Keep = float.NaN; break;
                case "FarCore": settings.FarCore = 0.1f; break;
                case "GroundHeight": settings.GroundHeight = -1f; break;
                case "Viscosity": settings.Viscosity = -1f; break;
                case "rings": (settings.ChordPanels, settings.SpanPanels) = (10, 256); break;
                default: (settings.SpanPanels, settings.StepsPerBeat, settings.Keep) = (256, 1000, 8f); break;
            }

            WakeWing[] wings = { new(ThinWing.Steady(1f, 0.0)) };
            Assert.That(Assert.Throws<ArgumentException>(() => _ = new FreeWake(settings, wings)).Message, Is.EqualTo(message));
        }

        [Test]
        public void AWingWithoutAnArea_IsNamed() => Assert.That(
            Assert.Throws<ArgumentException>(
                () => _ = new FreeWake(new WakeSettings(), new[] { new WakeWing(ThinWing.Steady(0f, 0.0)) })).Message,
            Does.StartWith("A wing has an area of 0"));
    }
}
