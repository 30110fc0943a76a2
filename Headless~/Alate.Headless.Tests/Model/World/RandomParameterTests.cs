using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// Wings with any parameters that are allowed, over the whole of their ranges, in any wind and spin: none ever falls back to its driven
    /// pose.
    /// </summary>
    public sealed class RandomParameterTests
    {
        private const int k_Steps = 30;
        private const uint k_Seed = 20261122;

        [Test]
        public void OfTwoWings_NoneIsReset() => AssertNoneIsReset(0, 2);

        [Test]
        [Explicit]
        [Category("Long")]
        public void OfNearlyAThousandMoreWings_NoneIsReset() => AssertNoneIsReset(2, 1000);

        private static void AssertNoneIsReset(int first, int end)
        {
            using var monarch = new SpeciesFlight(InsectCatalogue.Find("monarch").Wings[0], patches: 16);
            using var fishfly = new SpeciesFlight(InsectCatalogue.Find("fishfly").Wings[1], patches: 16);
            int resets = 0;
            for (int k = first; k < end; k++)
            {
                int own = Resets(k % 2 == 0 ? monarch : fishfly, new Unity.Mathematics.Random(k_Seed + 7919u * (uint)k));
                if (own > 0)
                    TestContext.Progress.WriteLine($"wing {k}: {own} resets");
                resets += own;
            }

            Assert.That(resets, Is.Zero);
        }

        private static int Resets(SpeciesFlight flight, Unity.Mathematics.Random random)
        {
            random.NextUInt();
            WingParameters p = flight.parameters;
            foreach (WingParameterRange range in WingParameterRange.All)
            {
                float share = random.NextFloat();
                float value = range.Minimum > 0f
                    ? range.Minimum * math.pow(range.Maximum / range.Minimum, share)
                    : math.lerp(range.Minimum, range.Maximum, share);
                range.Of(ref p) = range.Clamp(value);
            }

            p.substepsPerBeat = random.NextInt(WingParameters.MinSubsteps, 60);
            p.options.coefficients = (CoefficientSet)random.NextInt(0, 3);
            var air = new WingSurroundings
            {
                wind = random.NextFloat3Direction() * math.pow(10f, random.NextFloat(0f, 3f)),
                gravity = random.NextFloat3(-500f, 500f),
                speed = random.NextFloat(0f, 5f),
                angleOfAttack = random.NextFloat(-1.5f, 1.5f),
                angularVelocity = random.NextFloat3(-20f, 20f),
                hinge = random.NextFloat3(-0.5f, 0.5f),
            };
            Assert.That(p.FindProblem(), Is.Null);
            using var world = new WingWorld();
            WingHandle wing = world.Add(flight.Rig, p, air);
            float beat = 1f / world.Read(wing).Frequency;
            for (int k = 0; k < k_Steps; k++)
                world.Step(0.1f * beat * random.NextFloat(0.2f, 4f));
            world.Skin();
            foreach (SkinnedVertex vertex in world.Vertices(wing))
                Assert.That(math.all(math.isfinite(vertex.position)) && math.all(math.isfinite(vertex.normal)), "a vertex is not finite");
            WingReading reading = world.Read(wing);
            Assert.That(
                math.all(math.isfinite(reading.AirForce)) && math.all(math.isfinite(reading.AirMoment)), "the air's force is not finite");
            return reading.Resets;
        }
    }
}
