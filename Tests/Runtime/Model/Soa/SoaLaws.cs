using System;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Vectors, turns and functions of four wings at once against those of the mathematics package, and at their edges.</summary>
    public sealed unsafe class SoaLaws
    {
        [Test]
        public void Vectors_AreThoseOfTheMathematicsPackage_LaneByLane()
        {
            foreach (uint seed in Seeds.First(20))
            {
                var random = new Random(seed);
                SoaFloat3 a = Vector(ref random), b = Vector(ref random);
                float4 s = random.NextFloat4(-2f, 2f);
                SoaFloat3 sum = a + b, difference = a - b, opposite = -a, scaled = a * s, scaledToo = s * a, cross = SoaFloat3.Cross(a, b),
                    unit = SoaFloat3.NormalizeSafe(a), clamped = SoaFloat3.Clamp(a, -0.5f, 1f),
                    chosen = SoaFloat3.Select(a, b, new bool4(true, false, false, true));
                for (int lane = 0; lane < 4; lane++)
                {
                    AssertNear(sum[lane], a[lane] + b[lane]);
                    AssertNear(difference[lane], a[lane] - b[lane]);
                    AssertNear(opposite[lane], -1f * a[lane]);
                    AssertNear(scaled[lane], a[lane] * s[lane]);
                    AssertNear(scaledToo[lane], a[lane] * s[lane]);
                    AssertNear(cross[lane], math.cross(a[lane], b[lane]));
                    AssertNear(unit[lane], math.normalize(a[lane]));
                    AssertNear(clamped[lane], math.clamp(a[lane], -0.5f, 1f));
                    AssertNear(chosen[lane], lane == 0 || lane == 3 ? b[lane] : a[lane]);
                    Assert.That(SoaFloat3.Dot(a, b)[lane], Is.EqualTo(math.dot(a[lane], b[lane])).Within(1e-5f));
                    Assert.That(SoaFloat3.LengthSquared(a)[lane], Is.EqualTo(math.lengthsq(a[lane])).Within(1e-5f));
                }
            }

            AssertNear(SoaFloat3.NormalizeSafe(Lanes.All(0.9e-12f, 0f, 0f))[2], default);
            AssertNear(SoaFloat3.NormalizeSafe(Lanes.All(0f, -1.05e-12f, 0f))[2], new float3(0f, -1f, 0f));
        }

        [Test]
        public void ALane_IsSetAlone()
        {
            var v = new SoaFloat3(new float3(1f, 2f, 3f));
            v[2] = new float3(4f, 5f, 6f);
            for (int lane = 0; lane < 4; lane++)
                Assert.That(v[lane], Is.EqualTo(lane == 2 ? new float3(4f, 5f, 6f) : new float3(1f, 2f, 3f)));
        }

        [Test]
        public void Turns_AreThoseOfTheMathematicsPackage()
        {
            foreach (uint seed in Seeds.First(20))
            {
                var random = new Random(seed);
                quaternion a = random.NextQuaternionRotation(), b = random.NextQuaternionRotation();
                SoaQuaternion one = Of(a), other = Of(b);
                float3 v = random.NextFloat3(-2f, 2f);
                AssertNear((one * other)[1].value, math.mul(a, b).value);
                AssertNear(SoaQuaternion.Conjugate(one)[3].value, math.conjugate(a).value);
                AssertNear(SoaQuaternion.Rotate(one, new SoaFloat3(v))[2], math.rotate(a, v));
                AssertNear(SoaFloat3x3.Mul(new SoaFloat3x3(one), v)[0], math.rotate(a, v));
                AssertNear(SoaQuaternion.Normalize(one * 3f)[0].value, a.value);
                AssertNear((one + other)[0].value, a.value + b.value);
                AssertNear(SoaQuaternion.Select(one, other, new bool4(false, true, false, false))[1].value, b.value);
                AssertNear(SoaQuaternion.Select(one, other, new bool4(false, true, false, false))[2].value, a.value);

                // The shorter way round, whichever of its two numbers a turn has.
                float4 near = math.dot(a.value, b.value) < 0f ? -b.value : b.value;
                foreach (SoaQuaternion either in new[] { other, other * -1f })
                {
                    AssertNear(SoaQuaternion.Halfway(one, either)[1].value, math.normalize(a.value + near));
                    float4 difference = SoaQuaternion.Difference(one, either)[1].value;
                    Assert.That(math.lengthsq(difference), Is.EqualTo(math.lengthsq(near - a.value)).Within(1e-5f));
                }
            }
        }

        [Test]
        public void TheExponential_IsTheTurnAboutItsAxis()
        {
            for (float angle = 0f; angle <= 2.4f; angle += 0.2f)
            {
                float3 axis = math.normalize(new float3(0.3f, -0.8f, 0.5f));
                AssertNear(SoaQuaternion.Exp(new SoaFloat3(angle * axis))[3].value, quaternion.AxisAngle(axis, angle).value, 5e-6f);
            }
        }

        [Test]
        public void ASwing_BringsOneDirectionOntoTheOther_AndOfOppositeOnesIsNoNonsense()
        {
            foreach (uint seed in Seeds.First(20))
            {
                var random = new Random(seed);
                float3 from = random.NextFloat3Direction(), to = random.NextFloat3Direction();
                var swing = SoaQuaternion.Swing(new SoaFloat3(from), new SoaFloat3(to), new SoaQuaternion(default, 1f));
                AssertNear(math.rotate(swing[1], from), to, 1e-4f);
                Assert.That(math.dot(swing[1].value.xyz, from), Is.EqualTo(0f).Within(1e-5f), "square to both");

                quaternion first = random.NextQuaternionRotation();
                var both = SoaQuaternion.Swing(
                    new SoaFloat3(from), new SoaFloat3(to), new SoaQuaternion(new SoaFloat3(first.value.xyz), first.value.w));
                AssertNear(both[2].value, math.mul(swing[1], first).value, 1e-5f);
            }

            var x = new float3(1f, 0f, 0f);
            float4 back = SoaQuaternion.Swing(new SoaFloat3(x), new SoaFloat3(-x), new SoaQuaternion(default, 1f))[0].value;
            Assert.That(math.length(back), Is.EqualTo(1f).Within(1e-6f));
        }

        [TestCase(-3f, -1f)]
        [TestCase(-1e-20f, -1f)]
        [TestCase(0f, 1f)]
        [TestCase(2f, 1f)]
        public void TheSign_IsOneOrMinusOne(float value, float sign) => Assert.That(SoaMath.Sign(value).y, Is.EqualTo(sign));

        [TestCase(4f, 0.25f)]
        [TestCase(1.05e-12f, 1f / 1.05e-12f)]
        [TestCase(0.95e-12f, 0f)]
        [TestCase(0f, 0f)]
        [TestCase(-2f, 0f)]
        public void TheSafeReciprocal_IsZeroOfNothing(float value, float reciprocal) =>
            Assert.That(SoaMath.SafeReciprocal(value).z, Is.EqualTo(reciprocal).Within(1e-4).Percent);

        [TestCase(-1f, 0f)]
        [TestCase(0f, 0f)]
        [TestCase(0.25f, 0.15625f)]
        [TestCase(0.5f, 0.5f)]
        [TestCase(0.75f, 0.84375f)]
        [TestCase(1f, 1f)]
        [TestCase(7f, 1f)]
        public void TheSmoothStep_RisesFromNoughtToOne(float x, float y) => Assert.That(SoaMath.Smooth(x).w, Is.EqualTo(y).Within(1e-6f));

        [Test]
        public void SinesAndAngles_AreThoseOfTheLibrary()
        {
            for (int k = -400; k <= 400; k++)
            {
                float angle = 0.05f * k;
                SoaMath.SinCos(angle, out float4 sin, out float4 cos);
                Assert.That(sin.x, Is.EqualTo(Math.Sin(angle)).Within(3e-7), $"{angle}");
                Assert.That(cos.w, Is.EqualTo(Math.Cos(angle)).Within(3e-7), $"{angle}");
            }

            for (int k = 0; k <= 90; k++)
            {
                double angle = Math.PI * k / 180.0;
                foreach (double length in new[] { 1e-6, 1.0, 1e6 })
                {
                    Assert.That(SoaMath.QuadrantAngle((float)(length * Math.Sin(angle)), (float)(length * Math.Abs(Math.Cos(angle)))).y,
                        Is.EqualTo(angle).Within(1e-6), $"{k} degrees");
                }
            }

            Assert.That(SoaMath.QuadrantAngle(0f, 0f).x, Is.Zero);
        }

        [Test]
        public void ASymmetricBlock_TimesItsInverse_IsOne_AndKnowsWhetherItIsDefinite()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float size = math.exp(random.NextFloat(-30f, 30f)), diagonal = size * random.NextFloat(-0.3f, 1f);
                var block = SymmetricBlock.Diagonal(diagonal);
                double[,] m = { { diagonal, 0, 0 }, { 0, diagonal, 0 }, { 0, 0, diagonal } };
                for (int spring = 0; spring < 2; spring++)
                {
                    float3 d = random.NextFloat3Direction();
                    float axial = size * random.NextFloat(-1f, 1f), across = size * random.NextFloat(-0.2f, 0.2f);
                    float3 s = axial * d;
                    SymmetricBlock.Add(
                        &block, s.x * d.x + across, s.y * d.y + across, s.z * d.z + across, s.x * d.y, s.x * d.z, s.y * d.z);
                    for (int row = 0; row < 3; row++)
                    {
                        for (int column = 0; column < 3; column++)
                            m[row, column] += axial * (double)d[row] * d[column] + (row == column ? across : 0.0);
                    }
                }

                float3 v = random.NextFloat3(-1f, 1f);
                for (int row = 0; row < 3; row++)
                {
                    Assert.That(SymmetricBlock.Mul(&block, new SoaFloat3(v))[1][row],
                        Is.EqualTo(m[row, 0] * v.x + m[row, 1] * v.y + m[row, 2] * v.z).Within(1e-5 * size));
                }

                double second = m[0, 0] * m[1, 1] - m[0, 1] * m[0, 1], third = m[0, 0] * (m[1, 1] * m[2, 2] - m[1, 2] * m[1, 2])
                    - m[0, 1] * (m[0, 1] * m[2, 2] - m[0, 2] * m[1, 2]) + m[0, 2] * (m[0, 1] * m[1, 2] - m[0, 2] * m[1, 1]);
                double least = Math.Min(Math.Abs(m[0, 0]) / size, Math.Min(Math.Abs(second) / size / size,
                    Math.Abs(third) / size / size / size));
                if (least < 1e-3)
                    continue;
                SymmetricBlock inverse = block;
                bool4 definite = SymmetricBlock.InvertDefinite(&inverse);
                Assert.That(definite.z, Is.EqualTo(m[0, 0] > 0.0 && second > 0.0 && third > 0.0), $"seed {seed}");
                SoaFloat3 once = SymmetricBlock.Mul(&inverse, new SoaFloat3(v));
                AssertNear(SymmetricBlock.Mul(&block, once)[1], v, 2e-3f);
            }

            SymmetricBlock none = default;
            Assert.That(SymmetricBlock.InvertDefinite(&none).x, Is.False);
        }

        private static SoaFloat3 Vector(ref Random random) =>
            new SoaFloat3(random.NextFloat4(-2f, 2f), random.NextFloat4(-2f, 2f), random.NextFloat4(-2f, 2f));

        private static SoaQuaternion Of(quaternion q) =>
            new SoaQuaternion(new SoaFloat3(q.value.xyz), q.value.w);

        private static void AssertNear(float3 found, float3 wanted, float within = 1e-5f) =>
            Assert.That(math.length(found - wanted), Is.LessThan(within), $"{found}, not {wanted}");

        private static void AssertNear(float4 found, float4 wanted, float within = 1e-5f) =>
            Assert.That(math.length(found - wanted), Is.LessThan(within), $"{found}, not {wanted}");
    }
}
