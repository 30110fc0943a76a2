using System;
using System.Collections.Generic;

namespace Alate.Benchmarks;

/// <summary>
/// Whole frames of a crowd: four substeps and one skinning, against the plain wing, on one core. A round is a whole beat, because no two
/// frames of a beat cost the same.
/// </summary>
internal sealed class FrameComparison
{
    public const int Insects = 64;
    public const int FramesPerBeat = 6;

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
        OurBeat();
        PlainBeat();
        report.Check("the plain wing moves like ours", LargestDifference(), 2e-2);
        var time = Race.Run(
            new Contestant("ours", 1000 * FramesPerBeat * m_Swarm.Insects, OurBeat),
            new Contestant("plain", 1000 * FramesPerBeat * k_PlainInsects, PlainBeat));
        report.Ratio(Targets.Frame, time[0], time[1], time[1] / time[0]);
    }

    private void OurBeat()
    {
        for (var frame = 0; frame < FramesPerBeat; frame++)
            m_Swarm.Frame();
    }

    private void PlainBeat()
    {
        var substep = m_Swarm.FrameTime / Swarm.SubstepsPerFrame;
        for (var frame = 0; frame < FramesPerBeat; frame++)
        {
            foreach (var wing in m_Plain)
            {
                for (var k = 0; k < Swarm.SubstepsPerFrame; k++)
                    wing.Substep(substep);
                wing.Skin();
            }
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
