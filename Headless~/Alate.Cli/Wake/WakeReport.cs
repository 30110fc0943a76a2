namespace Alate.Cli;

/// <summary>Flies a plan, computes the wake of its last beat, and writes what came of it: all of the files or none.</summary>
internal static class WakeReport
{
    private const string k_Table = "wake.csv", k_Inflow = "inflow.json", k_Picture = "wake.png", k_Glb = "wake.glb", k_Plane = "plane.csv",
        k_PlanePicture = "plane.svg", k_Span = "span.csv", k_SpanPicture = "span.svg";

    /// <summary>
    /// Substeps of a flight that is not told any: at the default ones lift is up to 4 % low, which would be taken for the wake's.
    /// </summary>
    private const int k_Substeps = 192;

    /// <exception cref="UserException">Anything the user can mend; nothing has been written then.</exception>
    public static void Run(FlightPlan plan, WakePlan wake, TextWriter output)
    {
        plan = plan with { RecordsAir = true, Substeps = plan.Substeps ?? k_Substeps };
        if (wake.IsFree)
            plan = TrimmedFlight.Of(plan);
        var insect = Insect.Of(plan);
        PlanRange.CheckElasticity(plan, plan.Elasticity);
        string path = plan.Folder ?? Path.Combine("out", insect.Name + "-wake");
        string[] shown = wake.IsDrawn ? [k_SpanPicture, k_Plane, k_PlanePicture, k_Picture, k_Glb] : [],
            files = [k_Table, k_Span, k_Inflow, .. shown];
        using var folder = OutputFolder.Prepare(path, files);
        var terminal = new Terminal(output);
        using var rounds = new WakeRounds(plan, insect, wake);
        terminal.ShowProgress(rounds.Steps * wake.Rounds, (steps, stage) =>
        {
            for (int round = 0; round < wake.Rounds; round++)
            {
                int before = round * rounds.Steps;
                stage(wake.Rounds == 1 ? "shedding the wake" : $"round {round + 1}");
                rounds.Run(done => steps(before + done));
            }

            if (wake.IsDrawn)
            {
                stage("drawing");
                Show(rounds, folder);
            }

            stage("writing");
            folder.Write(k_Table, stream => CsvTable.Write(stream, WakeTable.Of(rounds)));
            folder.Write(k_Span, stream => CsvTable.Write(stream, SpanTable.Of(rounds.Wake, rounds.Beat)));
            folder.Write(k_Inflow, stream => InflowJson.Write(rounds.Wake, rounds.Found, stream));
            terminal.ShowTable($"{insect.DisplayName} with its wake", WakeTable.Summary(rounds));
            if (wake.Rounds > 1)
                terminal.ShowTable("Rounds of flight and wake", WakeTable.Convergence(rounds));
            foreach (string doubt in rounds.Wake.Doubts())
                terminal.Lines.Profile.Out.Writer.WriteLine("Note: " + doubt);
        });
        folder.Commit();
        terminal.ShowFiles(path, files);
    }

    private static void Show(WakeRounds rounds, OutputFolder folder)
    {
        WakeFlight wake = rounds.Wake;
        folder.Write(k_SpanPicture, stream => stream.Write(Encoding.UTF8.GetBytes(SpanPicture.Draw(wake, rounds.Beat))));
        using var smooth = WakeFlight.Smooth(wake.Flight, wake.Plan);
        folder.Write(k_Plane, stream => CsvTable.Write(stream, smooth.Plane.Table()));
        folder.Write(k_PlanePicture, stream => stream.Write(
            Encoding.UTF8.GetBytes(WakePlanePicture.Draw(smooth.Plane, wake.Flight.Insect.DisplayName))));
        folder.Write(k_Picture, stream => stream.Write(WakePicture.Draw(smooth)));
        folder.Write(k_Glb, stream => WingsGlb.Write(wake.Flight, stream, beside: new WakeGlb(new WakeLoop(smooth))));
    }
}
