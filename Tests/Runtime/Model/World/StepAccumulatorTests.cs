using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    public sealed class StepAccumulatorTests
    {
        private const float k_Step = 1f / 60f, k_Seconds = 1.5f;

        [TestCase(24f)]
        [TestCase(30f)]
        [TestCase(60f)]
        [TestCase(90f)]
        [TestCase(144f)]
        [TestCase(1000f)]
        public void TheSameTime_AtAnyFrameRate_ShowsTheSameWing(float framesPerSecond)
        {
            AssertSame(Tip(_ => 1f / framesPerSecond));
        }

        [Test]
        public void TheSameTime_InRandomFrames_ShowsTheSameWing()
        {
            var random = new Random(77);
            AssertSame(Tip(_ => random.NextFloat(0.0005f, 0.05f)));
        }

        [Test]
        public void Hitch_IsCutToTheMostSteps_AndDoesNotEcho()
        {
            var clock = new StepAccumulator(k_Step, 4);
            Assert.That(clock.Advance(1f), Is.EqualTo(4));
            Assert.That(clock.Advance(k_Step), Is.LessThanOrEqualTo(2));
            Assert.That(clock.Advance(k_Step), Is.EqualTo(1));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void TimeThatDoesNotPass_AsksForNoStep(float seconds)
        {
            var clock = new StepAccumulator(k_Step, 4);
            clock.Advance(0.5f * k_Step);
            Assert.That(clock.Advance(seconds), Is.Zero);
            Assert.That(clock.Alpha, Is.EqualTo(0.5f).Within(1e-5f));
        }

        [TestCase(0f, 4)]
        [TestCase(float.NaN, 4)]
        [TestCase(0.02f, 0)]
        public void BadLengthsAndCounts_AreNamed(float stepLength, int maxSteps)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new StepAccumulator(stepLength, maxSteps));
        }

        private static void AssertSame(float3 tip)
        {
            float3 reference = Tip(_ => k_Step);
            Assert.That(math.distance(tip, reference), Is.LessThan(0.01f * 0.61f));
        }

        // Where the last vertex, at the wing's tip, is shown when the time has passed.
        private static float3 Tip(Func<int, float> frameTime)
        {
            using (var flown = new FlownMonarch())
            {
                var clock = new StepAccumulator(k_Step, 100);
                double time = 0.0;
                for (int frame = 0; time < k_Seconds - 1e-6; frame++)
                {
                    float seconds = (float)math.min(frameTime(frame), k_Seconds - time);
                    time += seconds;
                    for (int steps = clock.Advance(seconds); steps > 0; steps--)
                        flown.world.Step(clock.StepLength);
                }

                flown.world.Skin(clock.Alpha);
                NativeArray<SkinnedVertex> vertices = flown.world.Vertices(flown.wing);
                return vertices[vertices.Length - 1].position;
            }
        }
    }
}
