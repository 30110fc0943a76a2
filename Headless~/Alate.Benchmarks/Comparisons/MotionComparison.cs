using System;

namespace Alate.Benchmarks;

/// <summary>Waves and driven pose of a wing: four wings in lanes against one after the other.</summary>
internal static unsafe class MotionComparison
{
    public static void Run(Report report, Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        WingPack view = pack.Pack;
        StepScratch scratch = pack.scratch;
        var beats = new PlainBeat[WingPack.Lanes];
        var motions = new PlainMotion[WingPack.Lanes];
        for (int lane = 0; lane < WingPack.Lanes; lane++)
        {
            beats[lane] = new PlainBeat(specimen.Parameters, specimen.FlightOf(lane));
            beats[lane].Follow(*view.beat, lane);
            motions[lane] = new PlainMotion(plain, specimen.Parameters);
        }

        void Lanes()
        {
            DelayedWaves.Evaluate(view, scratch);
            DrivenPose.Evaluate(view, scratch);
        }

        void Plain()
        {
            for (int lane = 0; lane < WingPack.Lanes; lane++)
                motions[lane].Evaluate(beats[lane]);
        }

        Lanes();
        Plain();
        for (int lane = 0; lane < WingPack.Lanes; lane++)
            Check(report, scratch, motions[lane], lane);
        double units = WingPack.Lanes * plain.JointCount;
        double[] time = Race.Run(new Contestant("lanes", units, Lanes), new Contestant("plain", units, Plain));
        report.Ratio(Targets.Motion, time[0], time[1], time[1] / time[0]);
    }

    // Velocities and accelerations relative to the largest.
    private static void Check(Report report, in StepScratch scratch, PlainMotion plain, int lane)
    {
        float position = 0f, velocity = 0f, fastest = 0f, acceleration = 0f, strongest = 0f;
        for (int joint = 0; joint < plain.positions.Length; joint++)
        {
            position = MathF.Max(position, (PlainRig.Plain(scratch.drivenPositions[joint][lane]) - plain.positions[joint]).Length());
            velocity = MathF.Max(velocity, (PlainRig.Plain(scratch.drivenVelocities[joint][lane]) - plain.velocities[joint]).Length());
            fastest = MathF.Max(fastest, plain.velocities[joint].Length());
            acceleration = MathF.Max(
                acceleration, (PlainRig.Plain(scratch.drivenAccelerations[joint][lane]) - plain.accelerations[joint]).Length());
            strongest = MathF.Max(strongest, plain.accelerations[joint].Length());
        }

        report.Check("scalar FK gives the lanes' positions", position, 1e-5);
        report.Check("scalar FK gives the lanes' velocities", velocity / fastest, 1e-4);
        report.Check("scalar FK gives the lanes' accelerations", acceleration / strongest, 1e-4);
    }
}
