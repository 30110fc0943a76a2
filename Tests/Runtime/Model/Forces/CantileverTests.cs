using System;
using System.Numerics;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Strips of measured stiffness under their own weight, beside beam theory.</summary>
    public sealed class CantileverTests
    {
        private const float k_Width = 0.1f;

        /// <summary>
        /// 1 N·m², the flexural stiffness of the whole strip, in wing masses times cubed wing lengths per squared second.
        /// </summary>
        private const double k_Stiffness = 1e4;

        [TestCase(5, 0.002)]
        [TestCase(5, 0.01)]
        [TestCase(5, 0.05)]
        [TestCase(5, 0.2)]
        [TestCase(5, 0.5)]
        [TestCase(9, 0.05)]
        [TestCase(9, 0.5)]
        [TestCase(3, 0.05)]
        public void AStrip_DroopsAsTheElastica(int joints, double load)
        {
            (double x, double y) = Droop(Strip(joints, 1f), 8.0 * k_Stiffness * load);
            (double exactX, double exactY) = Elastica(8.0 * load, _ => 1.0);

            Assert.That(y, Is.EqualTo(exactY).Within(0.5).Percent);
            Assert.That(x, Is.EqualTo(exactX).Within(0.002));
        }

        [Test]
        public void ASmallDroop_IsQLToTheFourthOverEightEI()
        {
            (double _, double y) = Droop(Strip(5, 1f), 8.0 * k_Stiffness * 0.01);

            Assert.That(y, Is.EqualTo(-0.01).Within(0.5).Percent);
        }

        [TestCase(1f, 0.25f)]
        [TestCase(0.25f, 1f, 0.5f)]
        public void ATaperedStrip_DroopsAsItsElastica(params float[] profile)
        {
            double Stiffness(double place)
            {
                double at = place * (profile.Length - 1);
                int before = Math.Min((int)at, profile.Length - 2);
                return Math.Exp(Math.Log(profile[before]) * (before + 1 - at) + Math.Log(profile[before + 1]) * (at - before));
            }

            (double _, double y) = Droop(Strip(5, profile), 8.0 * k_Stiffness * 0.02);
            (double _, double exact) = Elastica(8.0 * 0.02, Stiffness);

            Assert.That(y, Is.EqualTo(exact).Within(0.5).Percent);
        }

        // Two segments: w/8 (L⁴ − l⁴)/EI₁ + w/8 l⁴/EI₂, l the outer half's length. The step is a steep slope between two of sixteen values.
        [TestCase(0.125f)]
        [TestCase(0.5f)]
        [TestCase(4f)]
        public void AStripWithAStiffAndASoftHalf_DroopsAsTwoSegments(float outer)
        {
            float[] profile = new float[16];
            for (int k = 0; k < profile.Length; k++)
                profile[k] = k < 8 ? 1f : outer;
            const double k_Load = 0.01;
            (double _, double y) = Droop(Strip(9, profile), 8.0 * k_Stiffness * k_Load);

            Assert.That(y, Is.EqualTo(-k_Load * (15.0 / 16.0 + 1.0 / 16.0 / outer)).Within(3).Percent);
        }

        // Above the first resonance the joints answer in the first mode alone: by three times its frequency 12 % are missing.
        [TestCase(0.5, 1.0)]
        [TestCase(0.95, 2.0)]
        [TestCase(1.1, 2.5)]
        [TestCase(1.5, 4.0)]
        public void AShakenStrip_SwingsAsTheBeam(double ratio, double percent)
        {
            const double k_First = 3.5160152685, k_Damping = 0.1;
            double first = k_First * Math.Sqrt(k_Stiffness), frequency = ratio * first;
            Complex ours = Shaken(5, frequency, (float)k_Damping);

            // Of EI (1 + iωη) W'''' = ω² W, W(0) = 1: the tip against the base.
            Complex stiffness = k_Stiffness * (1.0 + new Complex(0.0, frequency * 2.0 * k_Damping / first));
            var wave = Complex.Pow(frequency * frequency / stiffness, 0.25);
            Complex exact = (Complex.Cos(wave) + Complex.Cosh(wave)) / (1.0 + Complex.Cos(wave) * Complex.Cosh(wave)) - 1.0;

            Assert.That(ours.Magnitude, Is.EqualTo(exact.Magnitude).Within(percent).Percent);
            Assert.That(ours.Phase, Is.EqualTo(exact.Phase).Within(0.02), "1°");
        }

        private static Complex Shaken(int joints, double frequency, float damping)
        {
            const int k_PerPeriod = 120, k_Periods = 16;
            WingParameters parameters = RigidPlate.Parameters;
            parameters.airDensity = 0f;
            parameters.jointLimit = 1.5f;
            parameters.dorsalAsymmetry = 1f;
            parameters.bendDamping = damping;
            parameters.maxFrequency = 0.1f;
            parameters.stiffnessUnit = (float)k_Stiffness;
            WingRig rig = TestWings.Bake(Strip(joints, 1f), TestWings.Rectangle(24, 4, chord: k_Width), 24);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, default);
                rig.Release();
                double dt = 2 * Math.PI / frequency / k_PerPeriod, shake = 1e-3;
                Complex sum = 0;
                for (int k = 1; k <= k_PerPeriod * k_Periods; k++)
                {
                    double phase = 2 * Math.PI * k / k_PerPeriod;
                    world.SetSurroundings(wing, new WingSurroundings
                    {
                        gravity = new float3(
                        0f, (float)(shake * frequency * frequency * Math.Cos(phase)), 0f)
                    });
                    world.Step((float)dt);
                    if (k > k_PerPeriod * (k_Periods - 1))
                        sum += world.Read(wing).JointPosition(1, joints - 1).y * Complex.Exp(new Complex(0, -phase));
                }

                return 2 * sum / k_PerPeriod / shake;
            }
        }

        private static WingSkeleton Strip(int joints, params float[] profile)
        {
            WingSkeleton skeleton = TestWings.Lattice(3, joints, chord: k_Width);
            for (int i = 0; i < 3; i++)
                skeleton.Chains[i].flexuralStiffness = Array.ConvertAll(profile, share => share * (i == 1 ? 0.5f : 0.25f));
            return skeleton;
        }

        // Place of the tip at rest under a weight, wing lengths.
        private static (double x, double y) Droop(WingSkeleton skeleton, double weight)
        {
            WingParameters parameters = RigidPlate.Parameters;
            parameters.airDensity = 0f;
            parameters.jointLimit = 1.5f;
            parameters.dorsalAsymmetry = 1f;
            parameters.stiffnessUnit = (float)k_Stiffness;
            WingRig rig = TestWings.Bake(skeleton, TestWings.Rectangle(24, 4, chord: k_Width), 24);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, new WingSurroundings { gravity = new float3(0f, (float)-weight, 0f) });
                rig.Release();
                for (int k = 0; k < 25; k++)
                    world.Step(0.02f);
                float3 tip = world.Read(wing).JointPosition(1, skeleton.JointsPerChain - 1);
                return (tip.x, tip.y);
            }
        }

        // EI θ' = M, M' = −w (1 − s) cos θ along the arc, by the midpoint rule and bisection of the moment at the root, until none is left
        // at the tip.
        private static (double x, double y) Elastica(double load, Func<double, double> stiffness)
        {
            double low = 0.0, high = load;
            (double x, double y, double moment) end = default;
            for (int k = 0; k < 45; k++)
            {
                double root = 0.5 * (low + high);
                end = Shoot(load, root, stiffness);
                if (end.moment > 0.0)
                    high = root;
                else
                    low = root;
            }

            return (end.x, -end.y);
        }

        private static (double x, double y, double moment) Shoot(double load, double root, Func<double, double> stiffness)
        {
            const int k_Steps = 400;
            double angle = 0.0, moment = root, x = 0.0, y = 0.0, h = 1.0 / k_Steps;
            for (int k = 0; k < k_Steps; k++)
            {
                double middle = (k + 0.5) * h;
                double halfAngle = angle + 0.5 * h * moment / stiffness(k * h),
                    halfMoment = moment - 0.5 * h * load * (1.0 - k * h) * Math.Cos(angle);
                x += h * Math.Cos(halfAngle);
                y += h * Math.Sin(halfAngle);
                angle += h * halfMoment / stiffness(middle);
                moment -= h * load * (1.0 - middle) * Math.Cos(halfAngle);
            }

            return (x, y, moment);
        }
    }
}
