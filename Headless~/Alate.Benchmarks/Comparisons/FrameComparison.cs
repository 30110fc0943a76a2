using System;
using System.Collections.Generic;

namespace Alate.Benchmarks;

/// <summary>Whole frames of a crowd: four substeps and one skinning, against the plain wing, on one core.</summary>
internal sealed class FrameComparison
{
    public const int Insects = 64;

    /// <summary>Fewer, for they take long; a plain wing costs the same in any number.</summary>
    private const int k_PlainInsects = 2;

    private readonly Specimen m_Specimen;
    private readonly List<PlainWing> m_Plain = [];
    private readonly Swarm m_Swarm;

    public FrameComparison(Specimen specimen, PlainRig plain, Swarm swarm)
    {
        m_Specimen = specimen;
        m_Swarm = swarm;
        for (var wing = 0; wing < 2 * k_PlainInsects; wing++)
            m_Plain.Add(new PlainWing(plain, specimen, specimen.FlightOf(wing)));
    }

    public void Run(Report report)
    {
        for (var frame = 0; frame < Swarm.FramesPerBeat; frame++)
        {
            m_Swarm.Frame();
            PlainFrame();
        }

        report.Check("the plain wing moves like ours", LargestDifference(), 2e-2);
        var time = Race.Run(
            m_Swarm.Contestant, new Contestant("plain", 1000 * k_PlainInsects, PlainFrame, Swarm.FramesPerBeat));
        report.Ratio(Targets.Frame, time[0], time[1], time[1] / time[0]);
    }

    private void PlainFrame()
    {
        var substep = m_Swarm.FrameTime / Swarm.SubstepsPerFrame;
        foreach (var wing in m_Plain)
        {
            for (var k = 0; k < Swarm.SubstepsPerFrame; k++)
                wing.Substep(substep);
            wing.Skin();
        }
    }

    // Of all vertices, wing lengths.
    private double LargestDifference()
    {
        var largest = 0f;
        for (var wing = 0; wing < m_Plain.Count; wing++)
        {
            var vertices = m_Swarm.World.Vertices(m_Swarm.Wings[wing]);
            for (var v = 0; v < vertices.Length; v++)
                largest = MathF.Max(largest, (PlainRig.Plain(vertices[v].position) - m_Plain[wing].positions[v]).Length());
        }

        return largest / m_Specimen.Rig.Frame.length;
    }
}
