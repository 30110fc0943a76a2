using System;
using System.Diagnostics;
using System.Linq;

namespace Alate.Benchmarks;

/// <summary>
/// Time of each part of a substep of four wings as they fly, timed in a copy of
/// <see cref="PackStep.Substep(ref WingPack, in StepScratch, int)"/> with clocks between its parts. A part that was
/// repeated by itself would meet springs that rest and strips that are slack.
/// </summary>
internal sealed unsafe class SubstepBreakdown : IDisposable
{
    private const int k_Beats = 400;

    private static readonly string[] s_Parts =
    [
        "waves", "driven pose", "carried surface", "loads", "hinges", "chain coupling", "turned chains", "elastic step", "joint frames",
        "readings", "joint motions", "keeping",
    ];

    private readonly FlyingPack m_Pack;

    // [substep of the beat][part] Seconds, the best of many beats.
    private readonly double[][] m_Best;
    private double[] m_Row;
    private int m_Part;
    private long m_Since;

    private SubstepBreakdown(Specimen specimen)
    {
        m_Pack = new FlyingPack(specimen, 100);
        m_Best = new double[(int)specimen.Parameters.substepsPerBeat][];
        for (int k = 0; k < m_Best.Length; k++)
        {
            m_Best[k] = new double[s_Parts.Length];
            Array.Fill(m_Best[k], double.PositiveInfinity);
        }
    }

    public static void Run(Report report, Specimen monarch, Specimen version01)
    {
        using SubstepBreakdown now = new(monarch), before = new(version01);
        for (int beat = 0; beat < k_Beats; beat++)
        {
            now.Beat();
            before.Beat();
        }

        now.Print(report, "us_per_wing_substep", "substep");
        before.Print(report, "us_per_wing_substep_01", "substep of version 0.1");
    }

    public void Dispose() => m_Pack.Dispose();

    private void Print(Report report, string key, string title)
    {
        double scale = 1e6 / (WingPack.Lanes * m_Best.Length);
        report.Figure(key, "whole", $"{title}: whole", "us/wing", scale * m_Best.Sum(row => row.Sum()));
        for (int part = 0; part < s_Parts.Length; part++)
            report.Figure(key, s_Parts[part], $"{title}: {s_Parts[part]}", "us/wing", scale * m_Best.Sum(row => row[part]));
    }

    private void Beat()
    {
        foreach (double[] row in m_Best)
        {
            m_Row = row;
            Substep(m_Pack.Pack, m_Pack.scratch, m_Pack.substep);
        }
    }

    // As PackStep.Substep.
    private void Substep(in WingPack pack, in StepScratch scratch, float h)
    {
        m_Part = 0;
        m_Since = Stopwatch.GetTimestamp();
        BeatClock.Advance(ref *pack.beat, *pack.parameters, *pack.surroundings, pack.options.cycleChange, h);
        DelayedWaves.Evaluate(pack, scratch);
        Done();
        DrivenPose.Evaluate(pack, scratch);
        Done();
        var step = ImplicitStep.Of(pack, h);
        CarriedSurface.Evaluate(pack, scratch, h);
        Done();
        JointLoads.Evaluate(pack, scratch, step);
        Done();
        Bending.Turn(pack, scratch, step);
        Done();
        if (pack.options.coupling == MembraneCoupling.TwoWay)
            ChainCoupling.Apply(pack, scratch, step);
        Done();
        Bending.Compose(pack, scratch);
        Bending.Pose(pack, scratch);
        Done();
        ElasticStep.Step(pack, scratch, step);
        Done();
        JointFrames.Evaluate(pack, scratch, scratch.pose);
        Done();
        AirReadings.Evaluate(pack, scratch, step);
        Done();
        JointFrames.Motions(pack, scratch, h);
        Done();
        PackStep.Keep(pack, scratch, h);
        PackReset.NotFinite(pack);
        Done();
    }

    private void Done()
    {
        long now = Stopwatch.GetTimestamp();
        m_Row[m_Part] = Math.Min(m_Row[m_Part], (now - m_Since) / (double)Stopwatch.Frequency);
        m_Part++;
        m_Since = Stopwatch.GetTimestamp();
    }
}
