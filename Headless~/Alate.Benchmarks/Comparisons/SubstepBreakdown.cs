namespace Alate.Benchmarks;

/// <summary>Where the time of a substep of four wings goes, and what skinning a wing costs.</summary>
internal static unsafe class SubstepBreakdown
{
    public static void Run(Report report, Specimen specimen)
    {
        // A pack of its own: a part that is repeated leads the wings nowhere.
        using var pack = new FlyingPack(specimen, 100);
        var view = pack.Pack;
        var scratch = pack.scratch;
        var h = pack.substep;
        (string Name, System.Action Work)[] parts =
        [
            ("whole", () => PackStep.Substep(view, scratch, h)),
            ("waves", () => DelayedWaves.Evaluate(view, scratch)),
            ("driven pose", () => DrivenPose.Evaluate(view, scratch)),
            ("carried surface", () => CarriedSurface.Evaluate(view, scratch, h)),
            ("loads", () => JointLoads.Evaluate(view, scratch)),
            ("bending", () => Bend(view, scratch, h)),
            ("elastic step", () => ElasticStep.Step(view, scratch, ImplicitStep.Of(view, h))),
            ("joint frames", () => JointFrames.Evaluate(view, scratch, scratch.pose)),
            ("joint motions", () => JointFrames.Motions(view, scratch, h)),
        ];
        var times = Race.Run(System.Array.ConvertAll(parts, part => new Contestant(part.Name, WingPack.Lanes * 1000, part.Work)));
        for (var k = 0; k < parts.Length; k++)
            report.Figure("us_per_wing_substep", parts[k].Name, $"substep: {parts[k].Name}", "us/wing", times[k]);
    }

    private static void Bend(in WingPack pack, in StepScratch scratch, float h)
    {
        Bending.Step(pack, scratch, ImplicitStep.Of(pack, h));
        Bending.Pose(pack, scratch);
    }
}
