using Alate.Benchmarks;

namespace Alate.Cli;

/// <summary>A full pack of one kind of wing whose beat is timed; skinning is left out.</summary>
internal sealed class BeatCost : IDisposable
{
    /// <summary>Steps of a beat: all counts of substeps that are compared are multiples of it.</summary>
    private const int k_Steps = 4;

    private const int k_SettledBeats = 2;

    private readonly WingWorld m_World = new();
    private readonly WingHandle m_Wing;
    private readonly float m_Step;

    private BeatCost(FlightPlan plan, InsectWing wing)
    {
        var rig = WingRig.Bake(wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = plan.Patches });
        for (int k = 0; k < WingPack.Lanes; k++)
            m_Wing = m_World.Add(rig, plan.ParametersOf(wing.Preset), plan.SurroundingsOf(wing.Preset, WingSide.Right));
        rig.Release();
        m_Step = 1f / (k_Steps * m_World.Read(m_Wing).Frequency);
        for (int k = 0; k < k_SettledBeats * k_Steps; k++)
            m_World.Step(m_Step);
    }

    /// <summary>Nanoseconds that a beat of one wing takes by each plan: they take turns, and the best of many rounds counts.</summary>
    public static double[] NanosecondsOf(InsectWing wing, IEnumerable<FlightPlan> plans)
    {
        var packs = plans.Select(plan => new BeatCost(plan, wing)).ToList();
        try
        {
            // A race reports the mean of a beat's steps.
            double[] steps = Race.Run(packs.Select(pack => new Contestant(wing.Name, WingPack.Lanes, pack.Step, k_Steps)).ToArray());
            return Array.ConvertAll(steps, step => k_Steps * step);
        }
        finally
        {
            packs.ForEach(pack => pack.Dispose());
        }
    }

    /// <summary>Substeps that a beat of a wing takes by a plan: more than it asks for where the air is fast.</summary>
    public static int SubstepsOf(InsectWing wing, FlightPlan plan)
    {
        using var pack = new BeatCost(plan, wing);
        return k_Steps * pack.m_World.Read(pack.m_Wing).Substeps;
    }

    public void Dispose() => m_World.Dispose();

    private void Step() => m_World.Step(m_Step);
}
