using System;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>Positions and normals of one flying monarch wing: grouped dual quaternions against what one would write at first.</summary>
internal sealed unsafe class SkinningComparison
{
    private readonly Specimen m_Specimen;
    private readonly PlainRig m_Plain;
    private readonly SkinTarget m_Target;
    private readonly DualQuaternion[] m_Palette;
    private readonly float4x4[] m_Matrices;
    private readonly SkinnedVertex[] m_Vertices;
    private readonly float3[] m_Positions;
    private readonly float3[] m_Normals;
    private ChunkBounds m_Bounds;
    private float m_Sink;

    public SkinningComparison(Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        m_Specimen = specimen;
        m_Plain = plain;
        var count = plain.meshVertices.Length;
        m_Vertices = GC.AllocateArray<SkinnedVertex>(count, pinned: true);
        m_Positions = new float3[count];
        m_Normals = new float3[count];
        m_Palette = GC.AllocateArray<DualQuaternion>(plain.JointCount, pinned: true);
        fixed (SkinnedVertex* vertices = m_Vertices)
            m_Target = new SkinTarget { rig = specimen.Rig.View, frame = specimen.Rig.Frame, vertices = vertices };
        fixed (DualQuaternion* palette = m_Palette)
            SkinPalette.Evaluate(pack.Pack, m_Target, 1f, palette);
        m_Matrices = Array.ConvertAll(m_Palette, Matrix);
    }

    public void Run(Report report)
    {
        Grouped();
        PlainDualQuaternions.Skin(m_Plain, m_Palette, m_Positions, m_Normals);
        report.Check("naive DQS gives the grouped DQS", LargestDifference(), 1e-5);
        PlainLinearBlend.Skin(m_Plain, m_Matrices, m_Positions, m_Normals);
        report.Check("naive LBS stays near the grouped DQS", LargestDifference(), 2e-2);

        var count = m_Vertices.Length;
        var time = Race.Run(
            new Contestant("grouped DQS", count, Grouped),
            new Contestant("naive DQS", count, () => PlainDualQuaternions.Skin(m_Plain, m_Palette, m_Positions, m_Normals)),
            new Contestant("naive LBS", count, () => PlainLinearBlend.Skin(m_Plain, m_Matrices, m_Positions, m_Normals)),
            new Contestant("multiply-adds", count, () => m_Sink += Calibration.MultiplyAdd(count)[0]));
        report.Ratio(Targets.NaiveDqs, time[0], time[1], time[1] / time[0]);
        report.Ratio(Targets.NaiveLbs, time[0], time[2], time[2] / time[0]);
        report.Ratio(Targets.Calibration, time[0], time[3], time[0] / time[3]);
    }

    private void Grouped()
    {
        fixed (DualQuaternion* palette = m_Palette)
            m_Bounds = SkinWingsJob.SkinQuads(m_Target, palette, 0, m_Target.rig.quadCount);
    }

    // In wing lengths, over positions and normals.
    private double LargestDifference()
    {
        var largest = 0f;
        for (var v = 0; v < m_Vertices.Length; v++)
        {
            largest = math.max(largest, math.length(m_Vertices[v].position - m_Positions[v]) / m_Specimen.Rig.Frame.length);
            largest = math.max(largest, 0.1f * math.length(m_Vertices[v].normal - m_Normals[v]));
        }

        return largest;
    }

    private static float4x4 Matrix(DualQuaternion joint)
    {
        float4 real = joint.real, dual = joint.dual;
        var translation = 2f * (real.w * dual.xyz - dual.w * real.xyz + math.cross(real.xyz, dual.xyz));
        return new float4x4(new quaternion(real), translation);
    }
}
