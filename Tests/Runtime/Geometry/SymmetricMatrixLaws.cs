using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Laws of the largest direction of random symmetric matrices.</summary>
    public sealed class SymmetricMatrixLaws
    {
        private const double k_Bound = 1e-6;

        [Test]
        public void LargestDirection_IsAUnitEigenvector_AlongWhichNoOtherDirectionIsLarger()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                double scale = math.exp(random.NextFloat(-20f, 20f));
                double[] upper = new double[6];
                for (int k = 0; k < 6; k++)
                    upper[k] = random.NextInt(4) == 0 ? 0.0 : scale * random.NextFloat(-1f, 1f);

                float3 v = SymmetricMatrix.LargestDirection(upper);

                double[] turned = Times(upper, v);
                double largest = Dot(turned, v);
                Assert.That(math.length(v), Is.EqualTo(1f).Within(k_Bound), $"seed {seed}");
                for (int k = 0; k < 3; k++)
                    Assert.That(turned[k], Is.EqualTo(largest * v[k]).Within(k_Bound * scale), $"seed {seed}, row {k}: A v = λ v");
                for (int k = 0; k < 20; k++)
                {
                    float3 other = random.NextFloat3Direction();
                    Assert.That(Dot(Times(upper, other), other), Is.LessThanOrEqualTo(largest + k_Bound * scale), $"seed {seed}: {other}");
                }
            }
        }

        private static double[] Times(double[] upper, float3 v) => new[]
        {
            upper[0] * v.x + upper[1] * v.y + upper[2] * v.z,
            upper[1] * v.x + upper[3] * v.y + upper[4] * v.z,
            upper[2] * v.x + upper[4] * v.y + upper[5] * v.z,
        };

        private static double Dot(double[] a, float3 b) => a[0] * b.x + a[1] * b.y + a[2] * b.z;
    }
}
