using System;
using System.Numerics;
using Unity.Collections.LowLevel.Unsafe;

namespace Alate.Benchmarks;

/// <summary>
/// Newton's method on the springs: block factors of a full pack of four wings against a dense factorisation for each wing.
/// </summary>
internal sealed unsafe class ElasticityComparison
{
    /// <summary>Newton iterations that are timed, and as many as bring both to the minimum.</summary>
    private const int k_Iterations = 2, k_Converged = 6;

    private readonly FlyingPack m_Pack;
    private readonly PlainNewton[] m_Plain = new PlainNewton[WingPack.Lanes];
    private readonly SoaFloat3[] m_Start;

    public ElasticityComparison(Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        m_Pack = pack;
        m_Start = new ReadOnlySpan<SoaFloat3>(pack.scratch.targets, plain.JointCount).ToArray();
        for (int lane = 0; lane < WingPack.Lanes; lane++)
        {
            m_Plain[lane] = new PlainNewton(plain, pack.Pack.parameters->springStiffness[lane]);
            for (int joint = 0; joint < plain.JointCount; joint++)
            {
                m_Plain[lane].anchors[joint] = PlainRig.Plain(pack.scratch.anchors[joint][lane]);
                m_Plain[lane].inertia[joint] = pack.scratch.inertia[joint][lane];
            }
        }
    }

    public void Run(Report report)
    {
        Lanes(k_Converged);
        Dense(k_Converged);
        report.Check("dense Newton gives the batched one's positions", LargestDifference(), 1e-4);
        const double units = 1000 * k_Iterations * WingPack.Lanes;
        double[] time = Race.Run(
            new Contestant("in blocks, four wings", units, () => Lanes(k_Iterations)),
            new Contestant("dense Cholesky", units, () => Dense(k_Iterations)));
        report.Ratio(Targets.Cholesky, time[0], time[1], time[1] / time[0]);
    }

    private void Lanes(int iterations)
    {
        fixed (SoaFloat3* start = m_Start)
            UnsafeUtility.MemCpy(m_Pack.scratch.positions, start, m_Start.Length * sizeof(SoaFloat3));
        NewtonSolver.Limits limits = NewtonSolver.Limits.Default;
        limits.newton = iterations;
        limits.tolerance = 0f;
        NewtonSolver.Minimise(m_Pack.Pack, m_Pack.scratch, limits);
    }

    private void Dense(int iterations)
    {
        for (int lane = 0; lane < WingPack.Lanes; lane++)
        {
            for (int joint = 0; joint < m_Start.Length; joint++)
                m_Plain[lane].positions[joint] = PlainRig.Plain(m_Start[joint][lane]);
            m_Plain[lane].Minimise(iterations, 0f);
        }
    }

    // Wing lengths.
    private double LargestDifference()
    {
        float largest = 0f;
        for (int lane = 0; lane < WingPack.Lanes; lane++)
        {
            for (int joint = 0; joint < m_Start.Length; joint++)
            {
                Vector3 ours = PlainRig.Plain(m_Pack.scratch.positions[joint][lane]);
                largest = MathF.Max(largest, (ours - m_Plain[lane].positions[joint]).Length());
            }
        }

        return largest;
    }
}
