using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>A loop over a NativeArray by its indexer against the same loop by a pointer; in Release both are without checks.</summary>
internal static unsafe class ArrayComparison
{
    private const int k_Length = 2048;

    public static void Run(Report report)
    {
        using var positions = new NativeArray<float4>(k_Length, Allocator.Persistent);
        using var velocities = new NativeArray<float4>(k_Length, Allocator.Persistent);
        for (int k = 0; k < k_Length; k++)
        {
            NativeArray<float4> array = velocities;
            array[k] = k;
        }

        var p = (float4*)positions.GetUnsafePtr();
        var v = (float4*)velocities.GetUnsafePtr();
        Indexed(positions, velocities);
        report.Check("indexer and pointer write the same memory", math.cmax(math.abs(p[k_Length - 1] - 0.001f * v[k_Length - 1])), 0);
        double[] time = Race.Run(
            new Contestant("indexer", k_Length, () => Indexed(positions, velocities)),
            new Contestant("pointer", k_Length, () => Pointed(p, v, k_Length)));
        report.Ratio(Targets.Indexer, time[0], time[1], time[0] / time[1]);
    }

    private static void Indexed(NativeArray<float4> positions, NativeArray<float4> velocities)
    {
        for (int k = 0; k < positions.Length; k++)
            positions[k] += velocities[k] * 0.001f;
    }

    private static void Pointed(float4* positions, float4* velocities, int length)
    {
        for (int k = 0; k < length; k++)
            positions[k] += velocities[k] * 0.001f;
    }
}
