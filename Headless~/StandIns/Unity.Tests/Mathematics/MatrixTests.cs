using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Mathematics;

public sealed class MatrixTests
{
    private static float4x4 RandomMatrix(ref Random random) =>
        new(random.NextFloat4(-1f, 1f), random.NextFloat4(-1f, 1f), random.NextFloat4(-1f, 1f), random.NextFloat4(-1f, 1f));

    [Test]
    public void Transpose_TurnsRowsIntoColumns()
    {
        var m = new float4x4(1f, 2f, 3f, 4f, 5f, 6f, 7f, 8f, 9f, 10f, 11f, 12f, 13f, 14f, 15f, 16f);
        Assert.That(m.c0, Is.EqualTo(new float4(1f, 5f, 9f, 13f)));
        float4x4 t = math.transpose(m);
        Assert.That(t.c0, Is.EqualTo(new float4(1f, 2f, 3f, 4f)));
        Assert.That(t.c1, Is.EqualTo(new float4(5f, 6f, 7f, 8f)));
        Assert.That(t.c2, Is.EqualTo(new float4(9f, 10f, 11f, 12f)));
        Assert.That(t.c3, Is.EqualTo(new float4(13f, 14f, 15f, 16f)));
    }

    [Test]
    public void Product_TakesRowsTimesColumns()
    {
        var random = new Random(8);
        float4x4 a = RandomMatrix(ref random), b = RandomMatrix(ref random);
        float4x4 product = math.mul(a, b);
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                double expected = 0.0;
                for (int k = 0; k < 4; k++)
                    expected += (double)a[k][row] * b[column][k];
                Assert.That(product[column][row], Is.EqualTo(expected).Within(1e-6));
            }
        }
    }

    [Test]
    public void Inverse_TimesTheMatrix_IsTheIdentity()
    {
        var random = new Random(9);
        for (int i = 0; i < 20; i++)
        {
            float4x4 m = RandomMatrix(ref random) + 2f * float4x4.identity;
            float4x4 product = math.mul(m, math.inverse(m));
            float3x3 part = new(m);
            float3x3 partProduct = math.mul(math.inverse(part), part);
            for (int column = 0; column < 4; column++)
                Assert.That(math.length(product[column] - float4x4.identity.At(column)), Is.LessThan(1e-5f));
            for (int column = 0; column < 3; column++)
                Assert.That(math.length(partProduct[column] - float3x3.identity.At(column)), Is.LessThan(1e-5f));
        }
    }

    [Test]
    public void Determinant_OfAProduct_IsTheProductOfDeterminants()
    {
        var random = new Random(10);
        float4x4 a = RandomMatrix(ref random), b = RandomMatrix(ref random);
        Assert.That(math.determinant(math.mul(a, b)), Is.EqualTo(math.determinant(a) * math.determinant(b)).Within(1e-6));
        Assert.That(math.determinant(float4x4.Scale(2f)), Is.EqualTo(8f));
    }

    [Test]
    public void TRS_ScalesThenRotatesThenTranslates()
    {
        var rotation = quaternion.EulerZXY(0.3f, 0.4f, 0.5f);
        float3 translation = new(1f, 2f, 3f), scale = new(2f, 3f, 4f), point = new(0.3f, -0.2f, 0.7f);
        float3 expected = translation + math.rotate(rotation, scale * point);
        Assert.That(math.distance(math.transform(float4x4.TRS(translation, rotation, scale), point), expected), Is.LessThan(1e-6f));
    }

    [Test]
    public void Text_ShowsTheRows()
    {
        Assert.That(float3x3.identity.ToString(), Is.EqualTo("float3x3(1f, 0f, 0f,  0f, 1f, 0f,  0f, 0f, 1f)"));
    }
}

internal static class Columns
{
    public static float4 At(this float4x4 m, int column) => m[column];

    public static float3 At(this float3x3 m, int column) => m[column];
}
