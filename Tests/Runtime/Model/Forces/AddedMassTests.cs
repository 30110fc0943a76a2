using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The air that a thin wing carries along: closed forms of flat plates, and light wings that stay stable.</summary>
    public sealed class AddedMassTests
    {
        private const double k_Frequency = 10.0, k_Omega = 2.0 * Math.PI * k_Frequency;
        private const int k_Substeps = 480;

        // π/4 ∫ c² dx: of a rectangle, and of a quarter of an ellipse whose chord is c √(1 − 0.99 x²).
        [TestCase(false, 0.25)]
        [TestCase(true, 0.25 * (1.0 - 0.33))]
        public void TheMassesOfAllJoints_AreTheCylindersAboutTheChords(bool elliptic, double squares)
        {
            SurfaceMesh surface = elliptic ? TestWings.Ellipse(48, 12) : TestWings.Rectangle(48, 12);
            WingRig rig = TestWings.Bake(elliptic ? TestWings.Fan() : TestWings.Lattice(), surface, 0);
            float sum = Masses(rig);
            rig.Release();

            Assert.That(sum, Is.EqualTo(0.25 * Math.PI * squares).Within(1.0).Percent);
        }

        // A chord that tapers evenly, c (1 − 0.8 x): where along the span the air is carried, as well as how much.
        [Test]
        public void TheMassesOfATaperedPlate_LieWhereItsChordsAre()
        {
            SurfaceMesh surface = TestWings.Rectangle(96, 8);
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].z *= 1f - 0.8f * surface.positions[k].x;
            WingRig rig = TestWings.Bake(TestWings.Lattice(), surface, 0);
            float moment = Moment(rig), sum = Masses(rig);
            rig.Release();

            Assert.That(sum, Is.EqualTo(0.25 * Math.PI * 0.25 * (1.0 - 0.8 + 0.64 / 3.0)).Within(0.3).Percent);
            Assert.That(moment, Is.EqualTo(0.25 * Math.PI * 0.25 * (0.5 - 1.6 / 3.0 + 0.16)).Within(0.3).Percent);
        }

        // A strip at x moves by φ x: −ρ π/4 c² φ̈ x across the plate, over a span of 1 half of −ρ π/4 c² φ̈.
        [Test]
        public void AFlappingPlate_FeelsThePlatesMass_TimesItsAcceleration()
        {
            const double amplitude = 0.4;
            WingParameters parameters = Driven(DrivenAngle.Flap, (float)amplitude);
            Compare(parameters, default, (phase, force) =>
            {
                double angle = amplitude * Math.Cos(phase), acceleration = -k_Omega * k_Omega * angle;
                double along = -Math.Sin(angle) * force.x + Math.Cos(angle) * force.y;
                return (along, -0.5 * Carried(parameters) * acceleration);
            });
        }

        // Pitched about the leading edge in a stream U along the chord: the non-circulatory lift of thin aerofoils, ρ π/4 c² (U α̇ + c/2
        // α̈), U cos α for larger angles.
        [Test]
        public void APitchingPlateInAStream_HasTheNonCirculatoryLiftOfThinAerofoils()
        {
            const double amplitude = 0.3, stream = 12.0;
            WingParameters parameters = Driven(DrivenAngle.Feather, (float)amplitude);
            Compare(parameters, new float3(0f, 0f, -(float)stream), (phase, force) =>
            {
                double attack = -amplitude * Math.Cos(phase), rate = amplitude * k_Omega * Math.Sin(phase),
                    acceleration = amplitude * k_Omega * k_Omega * Math.Cos(phase);
                double across = Math.Cos(attack) * force.y - Math.Sin(attack) * force.z;
                return (across, Carried(parameters) * (stream * Math.Cos(attack) * rate + 0.5 * RigidPlate.k_Chord * acceleration));
            });
        }

        [Test]
        public void AtRestInAnyStream_NothingIsCarriedAlong()
        {
            WingParameters parameters = RigidPlate.Parameters;
            var air = new WingSurroundings { wind = new float3(1f, 5f, -8f) };

            Assert.That(math.length(Flown(parameters, true, air)[^1].force - Flown(parameters, false, air)[^1].force), Is.LessThan(1e-4f));
        }

        // Turning about a body that is off the hinge is a wind at the hinge.
        [Test]
        public void AHingeOffTheBody_MeetsTheWindOfItsPlace()
        {
            WingParameters parameters = Driven(DrivenAngle.Feather, 0.3f);
            float3 turning = new float3(3f, -2f, 4f), hinge = new float3(0.6f, 0.5f, -0.7f), wind = new float3(1f, 2f, -9f);
            var off = new WingSurroundings { wind = wind, angularVelocity = turning, hinge = hinge };
            var on = new WingSurroundings { wind = wind - math.cross(turning, hinge), angularVelocity = turning };
            (float phase, float3 force)[] one = Flown(parameters, true, off), other = Flown(parameters, true, on);
            for (int k = 0; k < one.Length; k++)
                Assert.That(math.distance(one[k].force, other[k].force), Is.LessThan(2e-3f * math.length(other[k].force) + 0.05f));
        }

        // In a fluid in which that mass is more than a hundred times the wing's own.
        [Test]
        public void ALightWingThatBends_StaysStable()
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.airDensity = 1000f;
            parameters.substepsPerBeat = WingParameters.MinSubsteps;
            parameters.options.addedMass = true;
            WingRig rig = TestWings.Bake(TestWings.Fan(), TestWings.Ellipse(), 64);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters);
                rig.Release();
                for (int k = 0; k < 200; k++)
                    world.Step(0.01f);

                Assert.That(world.Read(wing).Resets, Is.Zero);
                Assert.That(world.Read(wing).Stretch, Is.LessThan(0.2f));
            }
        }

        // In the first moment after gravity sets in nothing but inertia holds a hinge: I of the wing, and of the air only across the
        // surface.
        [TestCase(0f, -1f, 0f)]
        [TestCase(0f, 0f, -1f)]
        public void AHingeLetGo_TurnsWithTheInertiaOfWingAndAir(float x, float y, float z)
        {
            WingParameters parameters = RigidPlate.Parameters;
            parameters.jointLimit = 0.5f;
            parameters.elasticity = 1e-3f;
            parameters.bendDamping = 0f;
            parameters.options.coupling = MembraneCoupling.OneWay;
            float3[] wing = LetGo(parameters, new float3(x, y, z) * 160f, out _), both;
            parameters.options.addedMass = true;
            both = LetGo(parameters, new float3(x, y, z) * 160f, out double[] shares);
            for (int bone = 0; bone < wing.Length; bone++)
            {
                double ratio = y != 0f ? both[bone].x / wing[bone].x : both[bone].y / wing[bone].y;
                Assert.That(ratio, Is.EqualTo(y != 0f ? shares[bone] : 1.0).Within(0.5).Percent, $"bone {bone}");
                Assert.That(shares[bone], Is.LessThan(0.8));
            }
        }

        private static unsafe float3[] LetGo(in WingParameters parameters, float3 gravity, out double[] shares)
        {
            WingRig rig = RigidPlate.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, new WingSurroundings { gravity = gravity });
                rig.Release();
                world.Step(1e-4f);
                WingReading reading = world.Read(wing);
                int bones = reading.JointsPerChain - 1;
                RigView view = rig.ViewAt(false);
                shares = new double[reading.ChainCount * bones];
                var bends = new float3[shares.Length];
                for (int bone = 0; bone < bends.Length; bone++)
                {
                    bends[bone] = reading.BendAngles(bone / bones, bone % bones);
                    shares[bone] = view.jointInertias[bone] / (view.jointInertias[bone] + parameters.airDensity * view.addedInertias[bone]);
                }

                return bends;
            }
        }

        private static double Carried(in WingParameters parameters) =>
            0.25 * Math.PI * RigidPlate.k_Chord * RigidPlate.k_Chord * parameters.airDensity;

        private static WingParameters Driven(DrivenAngle angle, float amplitude)
        {
            WingParameters parameters = RigidPlate.Parameters;
            parameters.substepsPerBeat = k_Substeps;
            parameters.kinematics.frequency = (float)k_Frequency;
            parameters.kinematics.SetHarmonic(angle, 1, amplitude, 0f);
            return parameters;
        }

        private static unsafe float Masses(WingRig rig)
        {
            float sum = 0f;
            RigView view = rig.ViewAt(false);
            for (int joint = 0; joint < view.jointCount; joint++)
                sum += view.addedMasses[joint];
            return sum;
        }

        private static unsafe float Moment(WingRig rig)
        {
            float sum = 0f;
            RigView view = rig.ViewAt(false);
            for (int joint = 0; joint < view.jointCount; joint++)
                sum += view.addedMasses[joint] * view.restJoints[joint].x;
            return sum;
        }

        // Differences with and without added mass over a beat, beside the closed form: within 1 % of its largest value.
        private static void Compare(in WingParameters parameters, float3 wind, Func<double, float3, (double Ours, double Wanted)> at)
        {
            var air = new WingSurroundings { wind = wind };
            (float phase, float3 force)[] with = Flown(parameters, true, air), without = Flown(parameters, false, air);
            (double Ours, double Wanted)[] pairs = with.Select((one, k) => at(one.phase, one.force - without[k].force)).ToArray();
            double largest = pairs.Max(pair => Math.Abs(pair.Wanted));

            Assert.That(largest, Is.GreaterThan(1.0));
            Assert.That(pairs.Max(pair => Math.Abs(pair.Ours - pair.Wanted)), Is.LessThan(0.01 * largest));
        }

        // The second half of a beat.
        private static (float phase, float3 force)[] Flown(WingParameters parameters, bool addedMass, in WingSurroundings air)
        {
            parameters.options.addedMass = addedMass;
            WingRig rig = RigidPlate.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, air);
                rig.Release();
                var flown = new (float, float3)[k_Substeps / 2];
                for (int k = 0; k < k_Substeps; k++)
                {
                    world.Step((float)(1.0 / (k_Frequency * k_Substeps)));
                    flown[k % flown.Length] = (world.Read(wing).Phase, world.Read(wing).AirForce);
                }

                return flown;
            }
        }
    }
}
