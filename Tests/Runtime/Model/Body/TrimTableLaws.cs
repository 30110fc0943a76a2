using System;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Tables between their points, and the bob that a point describes.</summary>
    public sealed unsafe class TrimTableLaws
    {
        private static readonly float[] s_Speeds = { 0f, 0.2f, 1f }, s_Climbs = { -0.3f, 0f, 0.1f, 0.5f };

        // What is bilinear on the grid is found again everywhere on it, and beyond its edges their values.
        [Test]
        public void BetweenItsPoints_ATableIsBilinear_OutsideItIsItsEdge()
        {
            using var memory = new TrimTableMemory(s_Speeds, s_Climbs);
            for (int s = 0; s < s_Speeds.Length; s++)
            {
                for (int c = 0; c < s_Climbs.Length; c++)
                {
                    float[] point = new float[TrimPoint.Floats];
                    for (int k = 0; k < point.Length; k++)
                        point[k] = Value(k, s_Speeds[s], s_Climbs[c]);
                    memory.Write(s, c, point);
                }
            }

            float* read = stackalloc float[TrimPoint.Floats];
            foreach (float speed in new[] { -1f, 0f, 0.05f, 0.2f, 0.7f, 1f, 3f })
            {
                foreach (float climb in new[] { -2f, -0.3f, -0.1f, 0f, 0.04f, 0.1f, 0.3f, 0.5f, 0.9f })
                {
                    memory.View.Read(speed, climb, read);
                    for (int k = 0; k < TrimPoint.Floats; k++)
                    {
                        Assert.That(read[k], Is.EqualTo(Value(k, math.clamp(speed, 0f, 1f),
                            math.clamp(climb, -0.3f, 0.5f))).Within(1e-3f), $"{k} at {speed}, {climb}");
                    }
                }
            }
        }

        [Test]
        public void ATable_MayBeFreedTwice()
        {
            var memory = new TrimTableMemory(s_Speeds, s_Climbs);
            memory.Dispose();
            Assert.That(memory.Dispose, Throws.Nothing);
        }

        [Test]
        public void ATableOfOnePoint_IsThatPoint()
        {
            using var memory = new TrimTableMemory(new[] { 0.4f }, new[] { 0.1f });
            float[] point = new float[TrimPoint.Floats];
            for (int k = 0; k < point.Length; k++)
                point[k] = k + 1f;
            memory.Write(0, 0, point);
            float* read = stackalloc float[TrimPoint.Floats];
            foreach (float at in new[] { -1f, 0.4f, 2f })
            {
                memory.View.Read(at, at, read);
                for (int k = 0; k < point.Length; k++)
                    Assert.That(read[k], Is.EqualTo(k + 1f));
            }
        }

        [Test]
        public void ANewTable_IsAllZeros()
        {
            using var memory = new TrimTableMemory(s_Speeds, s_Climbs);
            float* read = stackalloc float[TrimPoint.Floats];
            memory.View.Read(0.1f, 0.2f, read);
            for (int k = 0; k < TrimPoint.Floats; k++)
                Assert.That(read[k], Is.Zero);
        }

        [Test]
        public void TheBob_IsTheSumOfItsHarmonics([Values(1u, 2u, 3u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            float* point = stackalloc float[TrimPoint.Floats];
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = random.NextFloat(-1f, 1f);
            foreach (float phase in new[] { 0f, 0.4f, 2f, 4f, 6.28f })
            {
                double[] sums = new double[4];
                for (int q = 0; q < 4; q++)
                {
                    for (int k = 1; k <= 6; k++)
                    {
                        float* harmonic = point + TrimPoint.Bob + 2 * (6 * q + k - 1);
                        sums[q] += harmonic[0] * Math.Cos(k * phase) + harmonic[1] * Math.Sin(k * phase);
                    }
                }

                var bob = BodyBob.At(point, phase);
                Assert.That(bob.velocity.x, Is.Zero);
                Assert.That(new[] { bob.velocity.y, bob.velocity.z, bob.turn, bob.rate }, Is.EqualTo(sums).Within(1e-5));
            }
        }

        // Where the rates of the table are those of its turns, a body that is placed on its bob moves along it.
        [Test]
        public void ABodyOnItsBob_MovesAsTheBobGoesOn([Values(0.2f, 1.7f, 5f)] float phase, [Values(0f, 1.2f)] float heading)
        {
            const float rate = 70f, pitch = 0.6f, h = 1e-5f;
            var random = Random.CreateFromIndex(9);
            float* point = stackalloc float[TrimPoint.Floats];
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = random.NextFloat(-0.1f, 0.1f);
            for (int k = 0; k < 6; k++)
            {
                float* turn = point + TrimPoint.Bob + 2 * (12 + k), turning = turn + 12;
                turning[0] = (k + 1) * rate * turn[1];
                turning[1] = -(k + 1) * rate * turn[0];
            }

            point[TrimPoint.Pitch] = pitch;
            var mean = new float3(0.3f, 0.1f, -0.4f);
            FlyingBody body = default, after = default;
            body.reference.heading = after.reference.heading = heading;
            BodyMotion.PlaceOnBob(ref body, point, phase, rate, mean);
            BodyMotion.PlaceOnBob(ref after, point, phase + rate * h, rate, mean);
            var along = quaternion.AxisAngle(new float3(0f, 1f, 0f), heading);
            var bob = BodyBob.At(point, phase);
            Assert.That(math.distance(body.velocity, mean + math.rotate(along, bob.velocity)), Is.LessThan(1e-5f));
            float3 nose = math.rotate(math.conjugate(along), math.rotate(body.rotation, new float3(0f, 0f, 1f)));
            Assert.That(math.distance(nose, new float3(0f, math.sin(pitch - bob.turn), math.cos(pitch - bob.turn))), Is.LessThan(1e-5f),
                "a turn about X is nose down");
            Assert.That(math.distance(BodyMotion.Log(math.mul(math.conjugate(body.rotation), after.rotation)) / h, body.spin),
                Is.LessThan(0.2f));
            Assert.That(math.distance(math.rotate(math.conjugate(body.rotation), after.velocity - body.velocity) / h, body.acceleration),
                Is.LessThan(0.5f));
            Assert.That(math.distance((after.spin - body.spin) / h, body.spinRate), Is.LessThan(30f));
            Assert.That(math.length(body.spinRate), Is.GreaterThan(300f));
            Assert.That(body.middleRotation, Is.EqualTo(body.rotation));
            Assert.That(body.middleVelocity, Is.EqualTo(body.velocity));
            Assert.That(body.middleSpin, Is.EqualTo(body.spin));
        }

        private static float Value(int k, float speed, float climb) => k + (1f + k) * speed - 2f * climb + 0.5f * k * speed * climb;
    }
}
