using System;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>
    /// Momentum of the air against the force on the wings: the impulse of vortex rings is the sum of circulation times vector area, and
    /// the air gets what the wings lose.
    /// </summary>
    public sealed class WakeMomentumTests
    {
        private const int k_Beats = 4;

        private static float3 Impulse(FreeWake wake)
        {
            float3 sum = default;
            foreach (WingState wing in wake.Wings)
            {
                WingLattice lattice = wing.Lattice;
                for (int i = 0; i < lattice.ChordPanels; i++)
                {
                    for (int j = 0; j < lattice.SpanPanels; j++)
                    {
                        sum += lattice.Circulation[lattice.Ring(i, j)] * Area(
                            lattice.Rings[lattice.Corner(i, j)], lattice.Rings[lattice.Corner(i, j + 1)],
                            lattice.Rings[lattice.Corner(i + 1, j + 1)], lattice.Rings[lattice.Corner(i + 1, j)]);
                    }
                }

                for (int row = 0; row + 1 < wing.Sheet.RowCount; row++)
                {
                    for (int j = 0; j + 1 < wing.Sheet.Width; j++)
                    {
                        sum += wing.Sheet.Circulation(row, j) * Area(
                            wing.Sheet.Point(row, j), wing.Sheet.Point(row, j + 1), wing.Sheet.Point(row + 1, j + 1),
                            wing.Sheet.Point(row + 1, j));
                    }
                }
            }

            return sum;
        }

        // Vector area of a ring of four corners.
        private static float3 Area(float3 a, float3 b, float3 c, float3 d) => 0.5f * math.cross(c - a, d - b);

        private static ThinWing Beating() => new()
        {
            Span = 4f,
            Root = -2f,
            Pivot = 0.25,
            Move = t => (
                0.15 * Math.Cos(2.0 * Math.PI * t), -0.3 * Math.PI * Math.Sin(2.0 * Math.PI * t),
                0.1 + 0.05 * Math.Sin(2.0 * Math.PI * t), 0.1 * Math.PI * Math.Cos(2.0 * Math.PI * t)),
        };

        [Test]
        public void TheAirGets_WhatTheWingsLose([Values] WakeMethod method, [Values(0.3f, 0f)] float core)
        {
            var settings = new WakeSettings(method)
            {
                SpanPanels = 12,
                StepsPerBeat = 24,
                Keep = k_Beats + 1f,
                Stream = new float3(0f, 0f, -8f),
                SuctionAlongChord = true,
            };
            if (core > 0f)
                settings.NearCore = settings.FarCore = settings.BoundCore = core;
            // Sections of a thin plate: strips with a drag would lose momentum that no ring carries.
            using var wake = new FreeWake(
                settings, new[] { new WakeWing(Beating()) { Coefficients = null, Downwash = MeasuredDownwash.None } });
            float3 before = default, force = default;
            for (int k = 0; k < k_Beats * settings.StepsPerBeat; k++)
            {
                wake.Step();
                if (k == (k_Beats - 1) * settings.StepsPerBeat - 1)
                    before = Impulse(wake);
                if (k >= (k_Beats - 1) * settings.StepsPerBeat)
                    force += wake.Loads(0).Force / settings.StepsPerBeat;
            }

            float3 gained = Impulse(wake) - before;
            // With cores that widen, two vortices do not act on each other alike, and the momentum of the air drifts.
            double allowed = core > 0f ? 0.05 : 0.08;
            Assert.That(math.length(gained + force) / math.length(force), Is.LessThan(allowed));
        }
    }
}
