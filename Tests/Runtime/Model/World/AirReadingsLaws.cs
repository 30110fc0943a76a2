using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Force, moment and power of the air that are read, against converged runs and the loads that they are made of.</summary>
    public sealed class AirReadingsLaws
    {
        private const int k_Beats = 8, k_Few = 24, k_Many = 384;

        [Test]
        public void ForceMomentAndPower_OverABeat_AreThoseOfAConvergedRun([Values(0.25f, 1f, 4f)] float elasticity,
            [Values(0f, 30f)] float pitchDegrees)
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.elasticity *= elasticity;
            Means few = Fly(parameters, pitchDegrees, k_Few), many = Fly(parameters, pitchDegrees, k_Many);
            Assert.That(math.distance(few.force, many.force), Is.LessThan(0.035f * many.forceSize));
            Assert.That(math.distance(few.moment, many.moment), Is.LessThan(0.035f * many.momentSize));
            Assert.That(few.power, Is.EqualTo(many.power).Within(3.5).Percent);
        }

        [Test]
        public void TheErrorOfTheForce_FallsWithTheSquareOfTheSubstep()
        {
            float3 exact = Fly(Monarch.Parameters, 30f, 2 * k_Many).force;
            float coarse = math.distance(Fly(Monarch.Parameters, 30f, 16).force, exact),
                fine = math.distance(Fly(Monarch.Parameters, 30f, 64).force, exact);
            Assert.That(coarse, Is.GreaterThan(0f));
            Assert.That(fine, Is.LessThan(coarse / 6f), "a quarter of the substep: 4 of first order, 16 of second");
        }

        [Test]
        public void ThePrintedScheme_ReadsTheLoadsAsTheyAreMade()
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.options.timeScheme = TimeScheme.BackwardEuler;
            using (var flown = new FlownMonarch(parameters))
            {
                flown.world.RecordPatches(flown.wing, true);
                for (int step = 0; step < 40; step++)
                    flown.world.Step(flown.Substep);
                WingReading reading = flown.Reading;
                float3 sum = float3.zero;
                for (int patch = 0; patch < reading.PatchCount; patch++)
                    sum += reading.PatchForce(patch);
                Assert.That(math.length(sum), Is.GreaterThan(0f));
                Assert.That(math.distance(sum, reading.AirForce), Is.LessThan(1e-4f * math.length(sum)));
            }
        }

        private static Means Fly(in WingParameters parameters, float pitchDegrees, int substeps)
        {
            Means means = default;
            using (var flown = new FlownMonarch(parameters, 1.3f, math.radians(pitchDegrees)))
            {
                float dt = 1f / (substeps * flown.Reading.Frequency);
                for (int step = 0; step < k_Beats * substeps; step++)
                {
                    flown.world.Step(dt);
                    if (step < (k_Beats - 1) * substeps)
                        continue;
                    WingReading reading = flown.Reading;
                    means.force += reading.AirForce / substeps;
                    means.moment += reading.AirMoment / substeps;
                    means.power += reading.AirPower / substeps;
                    means.forceSize += math.length(reading.AirForce) / substeps;
                    means.momentSize += math.length(reading.AirMoment) / substeps;
                }
            }

            return means;
        }

        private struct Means
        {
            public float3 force, moment;
            public float power, forceSize, momentSize;
        }
    }
}
