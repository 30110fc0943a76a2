using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Laws of motion over random wings.</summary>
    public sealed unsafe class MotionLaws
    {
        private const int k_Wings = 6, k_ManyWings = 100;

        [Test]
        public void AnglesAndRates_AreContinuousFromCycleToCycle_HoweverTheBodyChanges()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var flight = new RandomFlight(seed);
                using (PackFixture fixture = flight.Fly())
                {
                    ref BeatState beat = ref *fixture.Pack.beat;
                    float dt = 1e-5f / beat.frequency.x;
                    beat.phase = 2f * math.PI - 0.5f * beat.rate * dt;
                    Advance(fixture, 0f);
                    Sample(fixture, out float3[] angles, out float3[] rates);
                    fixture.Pack.surroundings->speed = flight.Random.NextFloat(0f, 3f);
                    float4 cycles = beat.cycles;
                    Advance(fixture, dt);
                    Sample(fixture, out float3[] anglesAfter, out float3[] ratesAfter);
                    float largest = 2f * math.PI * beat.frequency.x;
                    Assert.That(beat.cycles.x, Is.EqualTo(cycles.x + 1f), $"seed {seed}: the cycle did not end");
                    for (int bone = 0; bone < angles.Length; bone++)
                    {
                        float jump = math.length(anglesAfter[bone] - angles[bone]), kink = math.length(ratesAfter[bone] - rates[bone]);
                        if (jump > 2e-3f || kink > 2e-3f * largest)
                            Assert.Fail($"seed {seed}, bone {bone}: angle jumps by {jump}, rate by {kink} of {largest}");
                    }
                }
            }
        }

        [Test]
        public void NoInputInRange_MakesAWingThatIsNotFinite() => AssertFinite(0, k_Wings);

        [Test]
        [Explicit]
        [Category("Long")]
        public void NoOtherInputInRange_MakesAWingThatIsNotFinite() => AssertFinite(k_Wings, k_ManyWings);

        private static void AssertFinite(int first, int end)
        {
            WingRig rig = Monarch.Rig(64);
            foreach (uint seed in Seeds.First(end).Skip(first))
            {
                var random = new Random(seed);
                WingParameters p = Anything(ref random);
                var air = new WingSurroundings
                {
                    wind = random.NextFloat3(-500f, 500f),
                    gravity = random.NextFloat3(-2000f, 2000f),
                    speed = random.NextFloat(0f, 20f),
                    angleOfAttack = random.NextFloat(-1.5f, 1.5f),
                };
                using (var world = new WingWorld())
                {
                    WingHandle wing = world.Add(rig, p, air);
                    for (int k = 0; k < 20; k++)
                        world.Step(random.NextFloat(0f, 0.05f));
                    world.Skin(random.NextFloat());
                    foreach (SkinnedVertex vertex in world.Vertices(wing))
                    {
                        if (!math.all(math.isfinite(vertex.position)) || !math.all(math.isfinite(vertex.normal)))
                            Assert.Fail($"seed {seed}: a vertex is not finite");
                    }
                }
            }

            rig.Release();
        }

        private static WingParameters Anything(ref Random random)
        {
            WingParameters p = WingParameters.Default;
            foreach (WingParameterRange range in WingParameterRange.All)
                range.Of(ref p) = math.lerp(range.Minimum, range.Maximum, math.pow(random.NextFloat(), 3f));
            p.options.coefficients = (CoefficientSet)random.NextInt(0, 3);
            p.options.tangent = (AirTangent)random.NextInt(0, 2);
            p.options.cycleChange = (CycleChange)random.NextInt(0, 2);
            p.options.torqueArm = (TorqueArm)random.NextInt(0, 2);
            p.options.springUnits = (SpringUnits)random.NextInt(0, 2);
            p.substepsPerBeat = random.NextInt(12, 48);
            return p.Clamped();
        }

        private static void Advance(PackFixture fixture, float dt)
        {
            BeatClock.Advance(ref *fixture.Pack.beat, *fixture.Pack.parameters, *fixture.Pack.surroundings, CycleChange.Smooth, dt);
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
        }

        private static void Sample(PackFixture fixture, out float3[] angles, out float3[] rates)
        {
            angles = new float3[fixture.rig.BoneCount];
            rates = new float3[angles.Length];
            for (int bone = 0; bone < angles.Length; bone++)
            {
                angles[bone] = fixture.scratch.angle[bone][0];
                rates[bone] = fixture.scratch.angleRate[bone][0] * fixture.Pack.beat->rate.x;
            }
        }
    }
}
