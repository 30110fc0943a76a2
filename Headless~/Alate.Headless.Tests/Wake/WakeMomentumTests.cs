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

        // Cores as wide as the chord move rings as no vortex does: the wider the old ones are, the worse panels keep the momentum. Zeros
        // stand for the defaults.
        [TestCase(WakeMethod.Strips, 0.3f, 0.3f, 0.3f, 0.05)]
        [TestCase(WakeMethod.Panels, 0.3f, 0.3f, 0.3f, 0.05, Explicit = true, Category = "Long,Faults")]
        [TestCase(WakeMethod.Strips, 0.25f, 0.4f, 0.1f, 0.05, Explicit = true, Category = "Long,Faults")]
        [TestCase(WakeMethod.Panels, 0.25f, 0.4f, 0.1f, 0.05)]
        [TestCase(WakeMethod.Strips, 0f, 0f, 0f, 0.05, Explicit = true, Category = "Long,Faults")]
        [TestCase(WakeMethod.Panels, 0f, 0f, 0f, 0.05)]
        public void TheAirGets_WhatTheWingsLose(WakeMethod method, float near, float far, float bound, double allowed)
        {
            var settings = new WakeSettings(method)
            {
                SpanPanels = 12,
                StepsPerBeat = 24,
                Keep = k_Beats + 1f,
                Stream = new float3(0f, 0f, -8f),
                SuctionAlongChord = true,
            };
            if (near > 0f)
                (settings.NearCore, settings.FarCore, settings.BoundCore) = (near, far, bound);
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
            Assert.That(math.length(gained + force) / math.length(force), Is.LessThan(allowed));
        }
    }
}
