using System;
using System.Numerics;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Trims and tables as data: there and back, bounds, neighbours, loads of a beat, and small matrices.</summary>
    public sealed class TrimLaws
    {
        private static readonly float[] s_Speeds = { 0f, 0.5f, 1.2f }, s_Climbs = { -0.3f, 0.1f, 0.4f };

        [Test]
        public void AState_IsWrittenAndRead_AsItIs([Values(11f, 60f)] float frequency)
        {
            TrimState state = State(3);
            float[] point = new float[TrimPoint.Floats];
            state.Write(point, frequency);
            Assert.That(point[TrimPoint.Pitch], Is.EqualTo((float)state.Pitch));
            Assert.That(point[TrimPoint.Drive], Is.EqualTo(state.FrequencyScale * frequency).Within(1e-4));
            var read = TrimState.Read(point, frequency);
            Assert.That(read.z, Is.EqualTo(state.z).Within(1e-6));
            Assert.That(read.bob, Is.EqualTo(state.bob).Within(1e-6));
            WingDrive drive = state.Drive(frequency);
            Assert.That(new[] { drive.frequency / frequency, drive.amplitude, drive.tilt, drive.meanSweep },
                Is.EqualTo(new[] { state.z[1], state.z[2], state.z[3], state.z[4] }).Within(1e-5));
            Assert.That(drive.meanFeather + drive.meanFlap, Is.Zero);
            TrimState copy = state.Copy();
            copy.z[0] = copy.bob[0] = 9;
            Assert.That(state.z[0], Is.Not.EqualTo(9));
            Assert.That(state.bob[0], Is.Not.EqualTo(9));
            Assert.That(copy.z[4], Is.EqualTo(state.z[4]));
        }

        [Test]
        public void TheBobOfThePitch_IsHalfOfItsRange()
        {
            var state = new TrimState();
            int turn = 2 * 2 * TrimPoint.Harmonics;
            state.bob[turn] = 0.3;
            state.bob[turn + 1] = 0.4;
            Assert.That(state.PitchBob, Is.EqualTo(0.5).Within(1e-3));
            state.bob[turn + 2] = 0.1;
            double least = 9, most = -9;
            for (double phase = 0; phase < 2 * Math.PI; phase += 1e-3)
            {
                double sum = 0.3 * Math.Cos(phase) + 0.4 * Math.Sin(phase) + 0.1 * Math.Cos(2 * phase);
                least = Math.Min(least, sum);
                most = Math.Max(most, sum);
            }

            Assert.That(state.PitchBob, Is.EqualTo(0.5 * (most - least)).Within(2e-3));
        }

        [Test]
        public void Bounds_AreThoseOfTheSolution()
        {
            double[] least = { -20, 0.85, 0.55, -40, -30 }, most = { 88, 1.2, 1.25, 60, 30 };
            for (int k = 0; k < TrimState.Unknowns; k++)
            {
                double unit = k == 1 || k == 2 ? 1 : Math.PI / 180;
                Assert.That(TrimState.Least(k), Is.EqualTo(least[k] * unit).Within(1e-6));
                Assert.That(TrimState.Most(k), Is.EqualTo(most[k] * unit).Within(1e-6));
            }
        }

        [Test]
        public void ATable_IsTheSameAfterItsText([Values] bool hasWake)
        {
            using TrimTable table = Table(out _, hasWake);
            table.Open(2, 0);
            string text = TrimTableText.Write(table, 17);
            using TrimTable read = TrimTableText.Read(text, 17);
            Assert.That((read.HasWake, read.View.HasWake), Is.EqualTo((hasWake, hasWake)));
            Assert.That(read.Speeds, Is.EqualTo(s_Speeds));
            Assert.That(read.ClimbRates, Is.EqualTo(s_Climbs));
            for (int s = 0; s < 3; s++)
            {
                for (int c = 0; c < 3; c++)
                {
                    Assert.That(read.IsClosed(s, c), Is.EqualTo(table.IsClosed(s, c)));
                    if (table.IsClosed(s, c))
                        Assert.That(read.Point(s, c), Is.EqualTo(table.Point(s, c)));
                }
            }

            Assert.That(read.Point(2, 0), Is.EqualTo(table.Point(2, 1)), "what is open has its neighbour's numbers");
            Assert.That(TrimTableText.Read(text, 18), Is.Null, "of another insect");
            Assert.That(TrimTableText.Read(text.Substring(0, text.Length / 2), 17), Is.Null, "cut off");
            Assert.That(TrimTableText.Read("no table", 17), Is.Null);
        }

        [Test]
        public void TopSpeedClimbsAndLevel_AreThoseOfThePointsThatClose()
        {
            using TrimTable table = Table(out _);
            Assert.That(table.TopSpeed, Is.EqualTo(1.2f));
            Assert.That(table.LevelClimb, Is.EqualTo(1));
            table.Open(0, 2);
            table.Open(1, 0);
            foreach ((float speed, float least, float most) in new[] { (-1f, -0.3f, 0.1f), (0f, -0.3f, 0.1f), (0.25f, -0.1f, 0.25f),
                (0.5f, 0.1f, 0.4f), (0.85f, -0.1f, 0.4f), (9f, -0.3f, 0.4f) })
            {
                table.Climbs(speed, out float slowest, out float fastest);
                Assert.That(slowest, Is.EqualTo(least).Within(1e-6f), $"{speed} m/s");
                Assert.That(fastest, Is.EqualTo(most).Within(1e-6f), $"{speed} m/s");
            }

            for (int c = 0; c < 3; c++)
                table.Open(2, c);
            Assert.That(table.TopSpeed, Is.EqualTo(0.5f));
            table.Climbs(9f, out float none, out float neither);
            Assert.That(none, Is.Zero);
            Assert.That(neither, Is.Zero);
            table.Acceleration = 0.7f;
            Assert.That(new float4(table.Limits.TopSpeed, table.Limits.LeastClimb, table.Limits.MostClimb, table.Limits.Acceleration),
                Is.EqualTo(new float4(0.5f, -0.3f, 0.4f, 0.7f)));
        }

        [Test]
        public void TheNearestTrim_IsNearestInSpeedAndClimb()
        {
            using TrimTable table = Table(out float[][] points);
            foreach ((float speed, float climb, int s, int c) in new[] { (0.24f, -0.11f, 0, 0), (0.26f, -0.09f, 1, 1),
                (0.9f, 0.26f, 2, 2), (-5f, 9f, 0, 2), (0.8f, -9f, 1, 0) })
            {
                float[] point = points[3 * s + c];
                WingDrive drive = table.DriveNear(speed, climb);
                Assert.That(new float4(drive.frequency, drive.amplitude, drive.tilt, drive.meanSweep),
                    Is.EqualTo(new float4(point[1], point[2], point[3], point[4])), $"{speed}, {climb}");
            }
        }

        [Test]
        public void ATableOfOneSpeed_HasItsClimbsAtAnySpeed()
        {
            using var table = new TrimTable(new[] { 0.5f }, new[] { -0.2f, 0.3f });
            table.Set(0, 0, new float[TrimPoint.Floats]);
            table.Set(0, 1, new float[TrimPoint.Floats]);
            foreach (float speed in new[] { 0f, 0.5f, 2f })
            {
                table.Climbs(speed, out float least, out float most);
                Assert.That((least, most), Is.EqualTo((-0.2f, 0.3f)));
            }
        }

        // A difference of speeds counts four times as much as one of climbs.
        [Test]
        public void WhatDoesNotClose_TakesItsNearestNeighboursNumbers()
        {
            using var table = new TrimTable(s_Speeds, s_Climbs);
            Assert.That(table.Fill(), Is.False);
            float[] a = new float[TrimPoint.Floats], b = new float[TrimPoint.Floats];
            table.Set(0, 0, a);
            table.Set(1, 2, b);
            Assert.That(table.Fill());
            Assert.That(table.Point(0, 2), Is.SameAs(a), "0.7 m/s of climb are nearer than 0.5 m/s of speed");
            Assert.That(table.Point(1, 0), Is.SameAs(b));
            Assert.That(table.Point(2, 1), Is.SameAs(b));
            Assert.That(table.IsClosed(2, 1), Is.False);
        }

        [Test]
        public void AnAddedSpeedOrClimb_LeavesTheOthersWhereTheyAre([Values(-0.5f, 0.2f, 0.3f, 2f)] float added)
        {
            using TrimTable table = Table(out float[][] points);
            table.Open(1, 1);
            using TrimTable speeds = table.WithSpeed(added), climbs = table.WithClimb(added);
            Check(speeds, points, (s, c) => Array.IndexOf(speeds.Speeds, s_Speeds[s]), (s, c) => c);
            Check(climbs, points, (s, c) => s, (s, c) => Array.IndexOf(climbs.ClimbRates, s_Climbs[c]));
            Assert.That(speeds.Speeds, Has.Length.EqualTo(4).And.Ordered);
            Assert.That(speeds.Speeds, Has.Member(added));
            Assert.That(climbs.ClimbRates, Has.Length.EqualTo(4).And.Ordered);
            Assert.That(climbs.ClimbRates, Has.Member(added));
            for (int k = 0; k < 3; k++)
            {
                Assert.That(speeds.IsClosed(Array.IndexOf(speeds.Speeds, added), k), Is.False);
                Assert.That(climbs.IsClosed(k, Array.IndexOf(climbs.ClimbRates, added)), Is.False);
            }
        }

        // A load of known harmonics, sampled evenly over a beat: means, cosines as real and sines as less imaginary parts.
        [Test]
        public void LoadsOfABeat_AreItsMeansAndHarmonics()
        {
            var loads = new BeatLoads();
            const int steps = 60;
            for (int step = 0; step < steps; step++)
            {
                double phase = 2 * Math.PI * (step + 0.5) / steps;
                FlyingBody body = default;
                body.force = new float3(9f, (float)(1 + 2 * Math.Cos(phase)), (float)(-3 + 4 * Math.Sin(2 * phase)));
                body.moment = new float3((float)(5 + Math.Cos(6 * phase)), 9f, 9f);
                body.power = step < steps / 2 ? 2f : 4f;
                body.damping = new float3x3(1f, 4f, 7f, 2f, 5f, 8f, 3f, 6f, 9f);
                loads.Add(body, phase, 1.0 / steps);
            }

            Assert.That(loads.mean, Is.EqualTo(new double[] { 1, -3, 5 }).Within(1e-5));
            Assert.That(loads.power, Is.EqualTo(3).Within(1e-6));
            for (int k = 0; k < TrimPoint.Harmonics; k++)
            {
                Assert.That((loads.harmonics[k, 0] - (k == 0 ? 2 : 0)).Magnitude, Is.LessThan(1e-5));
                Assert.That((loads.harmonics[k, 1] - (k == 1 ? new Complex(0, -4) : 0)).Magnitude, Is.LessThan(1e-5));
                Assert.That((loads.harmonics[k, 2] - (k == 5 ? 1 : 0)).Magnitude, Is.LessThan(1e-5));
            }

            Assert.That(loads.damping, Is.EqualTo(new double[,] { { 1, 4, 7 }, { 2, 5, 8 }, { 3, 6, 9 } }).Within(1e-5),
                "rows are loads, columns what they are damped by");
        }

        // The system with its integrals and last commands, run one beat, is what each of them says.
        [Test]
        public void TheAugmentedSystem_DoesWhatItsPartsDo()
        {
            var random = Random.CreateFromIndex(4);
            double[,] a = Any(4, 4, ref random), b = Any(4, 2, ref random), b1 = Any(4, 2, ref random);
            FlightGains.Augment(a, b, b1, 2, 0.09, out double[,] whole, out double[,] input);
            double[,] x = Any(8, 1, ref random), u = Any(2, 1, ref random);
            double[,] next = Dense.Add(Dense.Multiply(whole, x), Dense.Multiply(input, u));
            for (int i = 0; i < 4; i++)
            {
                double expected = b[i, 0] * u[0, 0] + b[i, 1] * u[1, 0] + b1[i, 0] * x[6, 0] + b1[i, 1] * x[7, 0];
                for (int j = 0; j < 4; j++)
                    expected += a[i, j] * x[j, 0];
                Assert.That(next[i, 0], Is.EqualTo(expected).Within(1e-12));
            }

            for (int i = 0; i < 2; i++)
            {
                Assert.That(next[4 + i, 0], Is.EqualTo(x[4 + i, 0] + 0.09 * x[i, 0]).Within(1e-12), "an integral");
                Assert.That(next[6 + i, 0], Is.EqualTo(u[i, 0]).Within(1e-12), "a last command");
            }
        }

        [Test]
        public void SmallMatrices_AreSolvedAsTheyAreMultiplied([Values(1u, 2u, 3u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            double[,] a = Any(5, 5, ref random), x = Any(5, 3, ref random);
            a[0, 0] = a[1, 1] = 0;
            double[,] product = Dense.Multiply(a, x), solved = Dense.SolveMany(a, product);
            Assert.That(Dense.Add(solved, x, -1), Is.EqualTo(new double[5, 3]).Within(1e-9));
            double[,] turned = Dense.Transpose(product);
            var complex = new Complex[5, 6];
            for (int i = 0; i < 5; i++)
            {
                for (int j = 0; j < 5; j++)
                {
                    complex[i, j] = new Complex(a[i, j], i == j ? 1 : 0);
                    complex[i, 5] += complex[i, j] * new Complex(x[j, 0], x[j, 1]);
                }

                for (int j = 0; j < 3; j++)
                {
                    double sum = 0;
                    for (int k = 0; k < 5; k++)
                        sum += a[i, k] * x[k, j];
                    Assert.That(product[i, j], Is.EqualTo(sum).Within(1e-12));
                    Assert.That(turned[j, i], Is.EqualTo(product[i, j]));
                }
            }

            Complex[] found = Dense.Solve(complex);
            for (int i = 0; i < 5; i++)
                Assert.That((found[i] - new Complex(x[i, 0], x[i, 1])).Magnitude, Is.LessThan(1e-9));
        }

        private static void Check(TrimTable table, float[][] points, Func<int, int, int> speed, Func<int, int, int> climb)
        {
            for (int s = 0; s < 3; s++)
            {
                for (int c = 0; c < 3; c++)
                {
                    bool isClosed = s != 1 || c != 1;
                    Assert.That(table.IsClosed(speed(s, c), climb(s, c)), Is.EqualTo(isClosed), $"{s}, {c}");
                    if (isClosed)
                        Assert.That(table.Point(speed(s, c), climb(s, c)), Is.SameAs(points[3 * s + c]), $"{s}, {c}");
                }
            }
        }

        private static TrimTable Table(out float[][] points, bool hasWake = false)
        {
            var table = new TrimTable(s_Speeds, s_Climbs);
            points = new float[9][];
            for (int k = 0; k < 9; k++)
            {
                points[k] = new float[TrimPoint.Floats];
                TrimState state = State((uint)k + 1);
                state.inflow[k % TrimPoint.Pairs].sine2.y = hasWake ? k + 1f : 0f;
                state.Write(points[k], 11f);
                table.Set(k / 3, k % 3, points[k]);
            }

            return table;
        }

        internal static TrimState State(uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            var state = new TrimState();
            for (int k = 0; k < state.z.Length; k++)
                state.z[k] = random.NextFloat(0.1f, 1f);
            for (int k = 0; k < state.bob.Length; k++)
                state.bob[k] = random.NextFloat(-1f, 1f);
            return state;
        }

        private static double[,] Any(int rows, int columns, ref Random random)
        {
            double[,] any = new double[rows, columns];
            for (int i = 0; i < rows; i++)
            {
                for (int j = 0; j < columns; j++)
                    any[i, j] = random.NextFloat(-1f, 1f);
            }

            return any;
        }
    }
}
