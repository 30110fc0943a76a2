using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>Positions and normals of one flying monarch wing: grouped dual quaternions against what one would write at first.</summary>
internal sealed unsafe class SkinningComparison
{
    private readonly Specimen m_Specimen;
    private readonly PlainRig m_Plain;
    private readonly SkinTarget m_Target;
    private readonly DualQuaternion[] m_Palette;
    private readonly PlainDualQuaternion[] m_PlainPalette;
    private readonly Matrix4x4[] m_Matrices;
    private readonly SkinnedVertex[] m_Vertices;
    private readonly Vector3[] m_Positions;
    private readonly Vector3[] m_Normals;
    private ChunkBounds m_Bounds;
    private float m_Sink;

    public SkinningComparison(Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        m_Specimen = specimen;
        m_Plain = plain;
        int count = plain.vertices.Length;
        m_Vertices = GC.AllocateArray<SkinnedVertex>(count, pinned: true);
        m_Positions = new Vector3[count];
        m_Normals = new Vector3[count];
        m_Palette = GC.AllocateArray<DualQuaternion>(plain.JointCount, pinned: true);
        fixed (SkinnedVertex* vertices = m_Vertices)
            m_Target = new SkinTarget { rig = specimen.Rig.View, frame = specimen.Rig.Frame, vertices = vertices };
        fixed (DualQuaternion* palette = m_Palette)
            SkinPalette.Evaluate(pack.Pack, m_Target, 1f, palette);
        m_PlainPalette = Array.ConvertAll(
            m_Palette, joint => new PlainDualQuaternion { real = PlainRig.Plain(joint.real), dual = PlainRig.Plain(joint.dual) });
        m_Matrices = Array.ConvertAll(m_PlainPalette, Matrix);
    }

    public void Run(Report report)
    {
        Grouped();
        PlainDualQuaternions();
        report.Check("naive DQS gives the grouped DQS", LargestDifference(), 1e-5);
        PlainLinearBlend();
        report.Check("naive LBS stays near the grouped DQS", LargestDifference(), 2e-2);

        int count = m_Vertices.Length;
        double[] time = Race.Run(
            new Contestant("grouped DQS", count, Grouped),
            new Contestant("naive DQS", count, PlainDualQuaternions),
            new Contestant("naive LBS", count, PlainLinearBlend),
            new Contestant("multiply-adds", count, () => m_Sink += Calibration.MultiplyAdd(count)[0]));
        report.Ratio(Targets.NaiveDqs, time[0], time[1], time[1] / time[0]);
        report.Ratio(Targets.NaiveLbs, time[0], time[2], time[2] / time[0]);
        report.Ratio(Targets.Calibration, time[0], time[3], time[0] / time[3]);
    }

    private void Grouped()
    {
        fixed (DualQuaternion* palette = m_Palette)
            m_Bounds = SkinWingsJob.SkinQuads(m_Target, palette, 0, m_Target.rig.quadCount, true);
    }

    private void PlainDualQuaternions() => PlainSkinning.DualQuaternions(m_Plain.vertices, m_PlainPalette, m_Positions, m_Normals);

    private void PlainLinearBlend() => PlainSkinning.LinearBlend(m_Plain.vertices, m_Matrices, m_Positions, m_Normals);

    // In wing lengths, over positions and normals.
    private double LargestDifference()
    {
        float largest = 0f;
        for (int v = 0; v < m_Vertices.Length; v++)
        {
            Vector3 position = PlainRig.Plain(m_Vertices[v].position) - m_Positions[v];
            Vector3 normal = PlainRig.Plain(m_Vertices[v].normal) - m_Normals[v];
            largest = MathF.Max(largest, position.Length() / m_Specimen.Rig.Frame.length);
            largest = MathF.Max(largest, 0.1f * normal.Length());
        }

        return largest;
    }

    private static Matrix4x4 Matrix(PlainDualQuaternion joint)
    {
        var matrix = Matrix4x4.CreateFromQuaternion(joint.real);
        matrix.Translation = PlainSkinning.Translation(joint.real, joint.dual);
        return matrix;
    }
}
