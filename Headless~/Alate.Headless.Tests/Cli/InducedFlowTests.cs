using System;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Momentum theory beside closed forms, and flights whose wings meet the air that they draw along.</summary>
    public sealed class InducedFlowTests
    {
        private const double k_Density = 1.225;

        [Test]
        public void InHover_TheDiscAcceleratesItsAir_ByHalfOfTheWake()
        {
            double force = 6.08e-3, area = 2.9e-3, w = MomentumTheory.Hover(force, k_Density, area);

            // Mass flow ρAw times the speed of the far wake, 2w.
            Assert.That(k_Density * area * w * 2 * w, Is.EqualTo(force).Within(1e-12));
            Assert.That(MomentumTheory.Speed(w, 0, 0), Is.EqualTo(w).Within(1e-12));
        }

        // Along the wake the quartic is a square: w (V + w) = ±w₀².
        [TestCase(0.5, 0.5)]
        [TestCase(4, 4)]
        [TestCase(1, -1)]
        [TestCase(1.9, -1.9)]
        public void InAVerticalStream_TheClosedFormHolds(double stream, double along)
        {
            double w = MomentumTheory.Speed(1, stream, along);

            Assert.That(w, Is.EqualTo(0.5 * (-along + Math.Sqrt(along * along + 4))).Within(1e-9));
        }

        // Two to two and a half hover speeds against the wake are the brink, where three roots are near one another.
        [TestCase(3)]
        [TestCase(2.5)]
        [TestCase(2.1)]
        [TestCase(2.02)]
        public void WhereTheStreamDrivesTheWings_TheRootIsTheWindmills(double stream) =>
            Assert.That(MomentumTheory.Speed(1, stream, -stream), Is.EqualTo(0.5 * (stream - Math.Sqrt(stream * stream - 4))).Within(1e-9));

        // Along the axis the span's circle does not count; across it the stream is wider by the circle over the swept area.
        [TestCase(1.5, 0.0)]
        [TestCase(-0.4, 0.0)]
        [TestCase(0.0, 2.0)]
        [TestCase(1.5, 2.0)]
        [TestCase(-0.3, 0.7)]
        public void InFlight_TheForceIsTheMassFlowTimesTheWake(double along, double across)
        {
            const double k_Force = 6e-3, k_Swept = 2.9e-3, k_Circle = 7.9e-3;
            double w = MomentumTheory.InFlight(k_Force, k_Density, k_Swept, k_Circle, along, across);

            // Glauert: T = 2ρAw times the size of the stream through the disc.
            double wide = across * k_Circle / k_Swept, through = Math.Sqrt((along + w) * (along + w) + wide * wide);
            Assert.That(2 * k_Density * k_Swept * w * through, Is.EqualTo(k_Force).Within(1e-9));
            if (across == 0)
            {
                double hover = k_Force / (2 * k_Density * k_Swept);
                Assert.That(w, Is.EqualTo(0.5 * (-along + Math.Sqrt(along * along + 4 * hover))).Within(1e-9));
            }
        }

        // All roots of the quartic at once, by the iteration of Durand and Kerner.
        [Test]
        public void GlauertsQuartic_HasThisRoot([Values(0.2, 1.0, 2.05, 2.5)] double stream,
            [Values(-86, -80, -20, 0, 30, 90)] double degrees)
        {
            double along = stream * Math.Sin(degrees * Math.PI / 180);
            Complex[] roots = [.. Enumerable.Range(0, 4).Select(k => Complex.Pow(new Complex(0.4, 0.9), k))];
            for (int round = 0; round < 500; round++)
            {
                for (int k = 0; k < 4; k++)
                {
                    Complex w = roots[k], value = (((w + 2 * along) * w + stream * stream) * w * w) - 1, others = 1;
                    for (int other = 0; other < 4; other++)
                        others *= other == k ? 1 : w - roots[other];
                    roots[k] -= value / others;
                }
            }

            double least = roots.Where(root => Math.Abs(root.Imaginary) < 1e-8 && root.Real > 0).Min(root => root.Real);

            Assert.That(MomentumTheory.Speed(1, stream, along), Is.EqualTo(least).Within(1e-6));
        }

        [Test]
        public void InFastFlight_TheInducedSpeedFalls_AsOneOverTheStream() =>
            Assert.That(MomentumTheory.Speed(1, 50, 0), Is.EqualTo(1.0 / 50).Within(0.1).Percent);

        // A wing that hardly sweeps: Prandtl's lifting line with the least induced drag, w = T / (2ρ π (b/2)² V).
        [Test]
        public void BehindAWingThatGlides_TheCircleOfTheSpanCounts() =>
            Assert.That(MomentumTheory.InFlight(6e-3, k_Density, 1e-4, 7.9e-3, 0, 20),
                Is.EqualTo(6e-3 / (2 * k_Density * 7.9e-3 * 20)).Within(0.1).Percent);

        [TestCase(1.0, 0.0)]
        [TestCase(1.2, 1.0)]
        public void AFlight_DrawsAsMuchAirAlong_AsItsMeanForceAsksFor(double factor, double speed)
        {
            var plan = new FlightPlan
            {
                Species = "dragonfly",
                Speed = speed,
                PitchDegrees = 20,
                Substeps = 24,
                Column = ComparisonColumn.RigidWing,
            };
            FlightRecord still = TetheredFlight.Fly(plan), flight = TetheredFlight.Fly(plan with { Induced = new InducedFlow(factor) });
            float3 force = plan.ToWorld(FlightSummary.Of(flight).MeanForce), wake = -math.normalize(force);
            double area = Enumerable.Range(0, 4).Sum(wing => Swept(flight.Wings[wing])) / 2;
            double circle = flight.Wings.Average(wing => Math.PI * wing.Wing.Preset.Size.wingLength * wing.Wing.Preset.Size.wingLength),
                along = -speed * wake.z;
            double wanted = factor * MomentumTheory.InFlight(math.length(force), flight.Wings[0].Wing.Preset.Size.fluidDensity, area,
                circle, along, Math.Sqrt(speed * speed - along * along));

            Assert.That(math.length(flight.InducedVelocity), Is.EqualTo(wanted).Within(2).Percent);
            Assert.That(math.dot(math.normalize(flight.InducedVelocity), wake), Is.GreaterThan(0.999f));
            Assert.That(math.length(force), Is.LessThan(math.length(FlightSummary.Of(still).MeanForce)));
            Assert.That(still.InducedVelocity, Is.EqualTo(default(float3)));
        }

        [Test]
        public void TheCommand_WritesWhatIsDrawnAlong_AndThatAddedMassCounts()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("fly", "monarch", "--induced-flow", "--added-mass", "--substeps", "12", "--no-pictures", "--out", run.Out),
                Is.Zero, run.Errors);
            JsonElement json = JsonDocument.Parse(System.IO.File.ReadAllText(System.IO.Path.Combine(run.Out, "summary.json"))).RootElement;
            Assert.That(json.GetProperty("options").GetProperty("induced_flow").GetDouble(), Is.EqualTo(1));
            Assert.That(json.GetProperty("options").GetProperty("added_mass").GetBoolean());
            Assert.That(
                json.GetProperty("induced_velocity_m_s").EnumerateArray().Sum(part => Math.Abs(part.GetDouble())), Is.GreaterThan(0.01));
            Assert.That(run.Output, Does.Contain("The wings draw air along at"));
        }

        [TestCase("--induced-flow must lie between 0 and 3; it is 4.", "--induced-flow", "4")]
        [TestCase("--induced-flow takes a finite number, not 'strong'.", "--induced-flow", "strong")]
        [TestCase("--added-mass is for flights on the spot; it does not go with --free.", "--added-mass", "--free")]
        [TestCase("--induced-flow is for flights on the spot; it does not go with --free.", "--induced-flow", "1", "--free")]
        [TestCase("--speed is for flights on the spot; it does not go with --free.", "--free", "--speed", "0.5")]
        [TestCase("--wind is for flights on the spot; it does not go with --free.", "--free", "--wind", "0,0,1")]
        [TestCase("--elasticity is for flights on the spot; it does not go with --free.", "--free", "--elasticity", "0.5")]
        [TestCase("--view is for flights on the spot; it does not go with --free.", "--free", "--view", "top")]
        [TestCase(
            "--free flies with the variant flight; it does not go with --variant expressive.", "--free", "--variant", "expressive")]
        public void BadUsage_IsOneLine(string message, params string[] options)
        {
            using var run = new CommandRun();

            Assert.That(run.Run(["fly", "monarch", .. options]), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Does.EndWith(message));
        }

        // The sector of one half stroke in a plane through the hinge: half of R² times the angle from end to end of the leading edge.
        private static double Swept(RecordedWing wing)
        {
            float3[] tips = wing.Frames.Select(frame => frame.Joints[wing.JointsPerChain - 1]).ToArray();
            double angle = tips
                .SelectMany(a => tips.Select(b => Math.Acos(Math.Clamp(math.dot(math.normalize(a), math.normalize(b)), -1f, 1f)))).Max();
            return 0.5 * angle * wing.Wing.Preset.Size.wingLength * wing.Wing.Preset.Size.wingLength * math.lengthsq(tips[0]);
        }
    }
}
