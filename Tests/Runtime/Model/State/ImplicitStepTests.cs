using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The weights of one implicit substep, and how exactly they integrate what has a closed form.</summary>
    public sealed unsafe class ImplicitStepTests
    {
        [TestCase(1e-4f)]
        [TestCase(0.02f)]
        public void EqualSubsteps_HaveTheWeightsOfBdf2(float dt)
        {
            ImplicitStep step = After(dt, dt);

            Assert.That(step.now.x, Is.EqualTo(4.0 / 3.0).Within(1e-6));
            Assert.That(step.before.x, Is.EqualTo(1.0 / 3.0).Within(1e-6));
            Assert.That(step.length.x, Is.EqualTo(2.0 / 3.0 * dt).Within(1e-6 * dt));
            Assert.That(step.dt.x, Is.EqualTo(dt));
        }

        [TestCase(0f)]
        [TestCase(2.41f)]
        [TestCase(30f)]
        public void WithoutAPast_OrAfterAMuchShorterSubstep_ItIsBackwardEuler(float ratio)
        {
            AssertEuler(After(ratio == 0f ? 0f : 0.01f / ratio, 0.01f));
        }

        [Test]
        public void TheFirstOrderScheme_IsBackwardEuler_WhateverItsPast()
        {
            AssertEuler(After(0.01f, 0.01f, TimeScheme.BackwardEuler));
        }

        [TestCase(0.2f)]
        [TestCase(1f)]
        [TestCase(2.3f)]
        public void Weights_AreExact_ForMotionThatAcceleratesEvenly(float ratio)
        {
            // y = t² at t = 0, with y₋₁ one earlier substep before and y′ = 2t at the end of the new one.
            const float dt = 0.5f;
            float earlier = dt / ratio;
            ImplicitStep step = After(earlier, dt);

            Assert.That(step.now.x - step.before.x, Is.EqualTo(1f).Within(1e-5f), "a wing at rest stays");
            Assert.That(-step.before.x * earlier * earlier + step.length.x * 2f * dt, Is.EqualTo(dt * dt).Within(1e-5f));
        }

        [Test]
        public void EachWingOfAPack_HasItsOwnPast()
        {
            var last = new float4(0f, 0.01f, 0.02f, 1e-3f);
            var step = ImplicitStep.Of(new WingPack { options = ModelOptions.Physical, lastSubstep = &last }, 0.01f);

            for (int lane = 0; lane < 4; lane++)
            {
                ImplicitStep alone = After(last[lane], 0.01f);
                Assert.That(step.now[lane], Is.EqualTo(alone.now.x), $"wing {lane}");
                Assert.That(step.before[lane], Is.EqualTo(alone.before.x), $"wing {lane}");
                Assert.That(step.length[lane], Is.EqualTo(alone.length.x), $"wing {lane}");
            }
        }

        [TestCase(-3.0, 1.0)]
        [TestCase(-3.0, 2.0)]
        [TestCase(1.5, 1.0)]
        [TestCase(1.5, 2.0)]
        public void Error_FallsWithTheSquareOfTheSubstep_ForEqualAndAlternatingOnes(double rate, double alternation)
        {
            double coarse = Error(rate, 32, alternation, TimeScheme.SecondOrder),
                fine = Error(rate, 128, alternation, TimeScheme.SecondOrder);

            Assert.That(0.5 * Math.Log(coarse / fine, 2.0), Is.EqualTo(2.0).Within(0.15), $"{coarse} to {fine}");
        }

        [Test]
        public void Error_OfTheFirstOrderScheme_FallsWithTheSubstep()
        {
            double coarse = Error(-3.0, 32, 1.0, TimeScheme.BackwardEuler), fine = Error(-3.0, 128, 1.0, TimeScheme.BackwardEuler);

            Assert.That(0.5 * Math.Log(coarse / fine, 2.0), Is.EqualTo(1.0).Within(0.1));
        }

        // y′ = rate · y over one second from y = 1, against its exponential; every second substep is longer by a factor.
        private static double Error(double rate, int substeps, double alternation, TimeScheme scheme)
        {
            double time = 0.0, y = 1.0, earlier = 1.0, last = 0.0, unit = 2.0 / (substeps * (1.0 + alternation));
            for (int k = 0; k < substeps; k++)
            {
                double dt = k % 2 == 0 ? unit : alternation * unit;
                ImplicitStep step = After((float)last, (float)dt, scheme);
                double next = (step.now.x * y - step.before.x * earlier) / (1.0 - step.length.x * rate);
                (earlier, y, last) = (y, next, dt);
                time += dt;
            }

            Assert.That(time, Is.EqualTo(1.0).Within(1e-6));
            return Math.Abs(y - Math.Exp(rate)) / Math.Exp(rate);
        }

        private static void AssertEuler(ImplicitStep step)
        {
            Assert.That(step.now.x, Is.EqualTo(1f));
            Assert.That(step.before.x, Is.Zero);
            Assert.That(step.length.x, Is.EqualTo(step.dt.x));
        }

        private static ImplicitStep After(float last, float dt, TimeScheme scheme = TimeScheme.SecondOrder)
        {
            float4 lastSubstep = last;
            ModelOptions options = ModelOptions.Physical;
            options.timeScheme = scheme;
            return ImplicitStep.Of(new WingPack { options = options, lastSubstep = &lastSubstep }, dt);
        }
    }
}
