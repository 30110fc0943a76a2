using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Streams without speed, sheets without area, springs without length: they have no direction, and make no nonsense.</summary>
    public sealed unsafe class DegenerateLaws
    {
        [TestCase(0.9e-6f, false)]
        [TestCase(1.05e-6f, true)]
        public void Air_IsFelt_FromAMillionthOfALengthPerSecond(float speed, bool isFelt)
        {
            var stream = new PatchStream { speed = speed, along = speed, lift = 1f, drag = 1f };
            float3 force = PatchAir.Force(stream, Lanes.All(0f, 0f, speed), Lanes.All(0f, 1f, 0f), 1e9f)[1];

            Assert.That(math.length(force) > 0f, Is.EqualTo(isFelt));
        }

        [TestCase(0.9e-6f, 0f)]
        [TestCase(1.05e-6f, 1f)]
        public void AStreamThatStandsOnThePatch_LiftsIt_FromAMillionthOfItAlongThePatch(float along, float lift)
        {
            // A lift of 1 on ½ρA = 1 in a stream of 1.
            var stream = new PatchStream { speed = 1f, across = 1f, along = along, lift = 1f };
            float3 force = PatchAir.Force(stream, Lanes.All(along, 1f, 0f), Lanes.All(0f, 1f, 0f), 1f)[2];

            Assert.That(math.length(force), Is.EqualTo(lift).Within(0.03f));
        }

        [TestCase(0f, 0f, 0f)]
        [TestCase(1f, 0f, 1f)]
        [TestCase(-1f, 0f, -1f)]
        [TestCase(0f, 1f, 0f)]
        public void Lift_PointsAsTheStreamGoesThroughThePatch(float across, float along, float side)
        {
            // Square to the stream, on the side of the normal to which the stream goes.
            const float angle = 0.6f;
            float sine = across == 0f ? 0f : across * math.sin(angle), cosine = across == 0f ? along : math.cos(angle);
            var wind = new float3(2f * cosine, 2f * sine, 0f);
            PatchStream stream = PatchAir.Evaluate(new SoaFloat3(wind), Lanes.All(0f, 1f, 0f));
            stream.lift = 0.5f;
            float3 force = PatchAir.Force(stream, new SoaFloat3(wind), Lanes.All(0f, 1f, 0f), 3f)[0];
            if (side != 0f)
            {
                Assert.That(math.dot(force, wind), Is.EqualTo(0f).Within(1e-5f));
                Assert.That(math.length(force), Is.EqualTo(0.5f * 3f * 4f).Within(1e-4f));
                Assert.That(math.sign(force.y), Is.EqualTo(side));
            }
            Assert.That((stream.speed.x, stream.across.y), Is.EqualTo((math.length(wind), wind.y)));
            Assert.That(stream.along.z, Is.EqualTo(math.abs(wind.x)).Within(1e-5f));
            Assert.That(stream.tangential.w, Is.EqualTo(stream.along.w));
        }

        [Test]
        public void NoSetOfCoefficients_HasAnyNonsense_InStillAir(
            [Values(CoefficientSet.Dickinson1999, CoefficientSet.Paper, CoefficientSet.FlatPlate, CoefficientSet.Dragonfly)]
            CoefficientSet set)
        {
            PatchStream* streams = stackalloc PatchStream[1];
            streams[0] = default;
            Coefficients.Evaluate(new ModelOptions { coefficients = set, clampLift = true }, streams, 1);

            Assert.That(math.all(math.isfinite(streams[0].lift) & math.isfinite(streams[0].drag)), Is.True);
            Assert.That(streams[0].drag.x, Is.GreaterThan(0f), "that of an edge against the stream");
        }

        [TestCase(0f)]
        [TestCase(0.03f)]
        [TestCase(0.05f)]
        [TestCase(0.5f)]
        public void DampingOfAPatch_IsThatOfASineOfATwentiethAtLeast(float sine)
        {
            float cosine = math.sqrt(1f - sine * sine);
            var stream = new PatchStream { speed = 2f, across = -2f * sine, along = 2f * cosine, lift = 0.7f, drag = 0.3f };
            float damping = PatchAir.Damping(stream, 1.5f, out float4 attack).y, least = math.max(sine, 0.05f);

            Assert.That(attack.x, Is.EqualTo(sine).Within(1e-6f));
            float slope = 0.7f * cosine / least + 0.3f;
            Assert.That(damping, Is.EqualTo(1.5f * 2f * (1f + least * least) * slope).Within(1e-3).Percent);
        }

        [Test]
        public void AWingFoldedToAPoint_MeetsNoForceThatIsNoNumber()
        {
            using (var fixture = new PackFixture(Monarch.Rig(32), Monarch.Parameters, Monarch.Flying()))
            {
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                {
                    fixture.scratch.carriedPositions[joint] = fixture.scratch.carriedSpans[joint] = fixture.scratch.forces[joint] = default;
                    fixture.scratch.carriedFrames[joint] = default;
                    fixture.scratch.carriedTurning[joint] = default;
                    fixture.scratch.airDamping[joint] = 0f;
                }
                Aerodynamics.Apply(fixture.Pack, fixture.scratch);
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                {
                    Assert.That(math.all(math.isfinite(fixture.scratch.forces[joint][0])), Is.True, $"joint {joint}");
                    Assert.That(math.isfinite(fixture.scratch.airDamping[joint].x), Is.True, $"joint {joint}");
                }
            }
        }

        [Test]
        public void SpringsOfNoLength_PullNowhere_AndFramesOfNoBonesAreTurns()
        {
            using (var fixture = new PackFixture(Monarch.Rig(32), Monarch.Parameters))
            {
                StepScratch scratch = fixture.scratch;
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                {
                    scratch.positions[joint] = scratch.anchors[joint] = scratch.targets[joint] = default;
                    scratch.inertia[joint] = 1f;
                }
                float4 energy = SpringEnergy.Value(fixture.Pack, scratch, scratch.positions);
                SpringEnergy.Linearise(fixture.Pack, scratch, scratch.positions, true);
                Assert.That(energy.x, Is.Positive.And.LessThan(float.PositiveInfinity), "they are as short as they can");
                JointFrames.Evaluate(fixture.Pack, scratch, scratch.pose);
                for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                {
                    Assert.That(math.length(scratch.gradient[joint][1]), Is.Zero, $"joint {joint}");
                    Assert.That(math.length(scratch.pose[joint].rotation[3].value), Is.EqualTo(1f).Within(1e-5f), $"joint {joint}");
                }
            }
        }
    }
}
