using System;
using System.Collections.Generic;
using Unity.Collections;

namespace Alate.Benchmarks;

/// <summary>
/// Measures whole frames of a crowd on one core, substeps and one skinning each: the current model, version 0.1's, and the plain wing,
/// which computes version 0.1's model.
/// </summary>
internal sealed class FrameComparison
{
    public const int Insects = 64;

    /// <summary>Fewer, for they take long; a plain wing costs the same in any number.</summary>
    private const int k_PlainInsects = 2;

    private readonly Specimen m_Version01;
    private readonly List<PlainWing> m_Plain = [];
    private readonly Swarm m_Earlier;
    private readonly Swarm m_Swarm;

    public FrameComparison(Specimen version01, PlainRig plain, Swarm earlier, Swarm swarm)
    {
        m_Version01 = version01;
        m_Earlier = earlier;
        m_Swarm = swarm;
        for (int wing = 0; wing < 2 * k_PlainInsects; wing++)
            m_Plain.Add(new PlainWing(plain, version01, version01.FlightOf(wing)));
    }

    public void Run(Report report)
    {
        for (int frame = 0; frame < Swarm.FramesPerBeat; frame++)
        {
            m_Earlier.Frame();
            m_Swarm.Frame();
            PlainFrame();
        }

        report.Check("the plain wing moves like ours", LargestDifference(), 2e-2);
        double[] time = Race.Run(
            m_Swarm.Contestant, m_Earlier.Contestant, new Contestant("plain", 1000 * k_PlainInsects, PlainFrame, Swarm.FramesPerBeat));
        report.Ratio(Targets.Frame, time[0], time[2], time[2] / time[0]);
        report.Ratio(Targets.EarlierFrame, time[1], time[2], time[2] / time[1]);
        report.Ratio(Targets.FrameShare, time[0], time[1], time[0] / time[1]);
    }

    private void PlainFrame()
    {
        foreach (PlainWing wing in m_Plain)
        {
            for (int k = 0; k < m_Earlier.SubstepsPerBeat / Swarm.FramesPerBeat; k++)
                wing.Substep(m_Earlier.Substep);
            wing.Skin();
        }
    }

    // Of all vertices, wing lengths.
    private double LargestDifference()
    {
        float largest = 0f;
        for (int wing = 0; wing < m_Plain.Count; wing++)
        {
            NativeArray<SkinnedVertex> vertices = m_Earlier.World.Vertices(m_Earlier.Wings[wing]);
            for (int v = 0; v < vertices.Length; v++)
                largest = MathF.Max(largest, (PlainRig.Plain(vertices[v].position) - m_Plain[wing].positions[v]).Length());
        }

        return largest / m_Version01.Rig.Frame.length;
    }
}
