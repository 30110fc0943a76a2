using System.Runtime.Intrinsics;

namespace Alate.Benchmarks;

/// <summary>Measures the machine's best rate: multiply-adds of four lanes in ten independent chains, nothing else.</summary>
internal static class Calibration
{
    /// <summary>Multiply-adds that the grouped skinning of one vertex amounts to.</summary>
    public const double PerVertex = 18.75;

    private const int k_Chains = 10;

    /// <summary>Runs as many multiply-adds as the skinning of a number of vertices takes.</summary>
    public static Vector128<float> MultiplyAdd(int vertices)
    {
        int count = (int)(vertices * PerVertex / k_Chains);
        Vector128<float> factor = Vector128.Create(0.999f), term = Vector128.Create(0.001f);
        Vector128<float> a = term, b = term, c = term, d = term, e = term, f = term, g = term, h = term, i = term, j = term;
        for (int k = 0; k < count; k++)
        {
            a = Vector128.FusedMultiplyAdd(a, factor, term);
            b = Vector128.FusedMultiplyAdd(b, factor, term);
            c = Vector128.FusedMultiplyAdd(c, factor, term);
            d = Vector128.FusedMultiplyAdd(d, factor, term);
            e = Vector128.FusedMultiplyAdd(e, factor, term);
            f = Vector128.FusedMultiplyAdd(f, factor, term);
            g = Vector128.FusedMultiplyAdd(g, factor, term);
            h = Vector128.FusedMultiplyAdd(h, factor, term);
            i = Vector128.FusedMultiplyAdd(i, factor, term);
            j = Vector128.FusedMultiplyAdd(j, factor, term);
        }

        return a + b + c + d + e + f + g + h + i + j;
    }
}
