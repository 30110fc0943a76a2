namespace Alate.Cli;

/// <summary>Flies a plan, shows how it gets on, and writes what came of it: all of the files or none.</summary>
internal static class FlightReport
{
    private const string k_Strip = "strip.png", k_Map = "stretch.png", k_Glb = "wings.glb", k_Joints = "joints.csv",
        k_Forces = "forces.csv", k_Span = "spanwise.csv", k_Summary = "summary.json";

    /// <exception cref="UserException">Anything the user can mend; nothing has been written then.</exception>
    public static void Run(FlightPlan plan, TextWriter output)
    {
        plan = plan with { RecordsAir = true };
        var insect = Insect.Of(plan);
        PlanRange.CheckElasticity(plan, plan.Elasticity);
        using var flight = new TetheredFlight(plan, insect);
        string path = plan.Folder ?? Path.Combine("out", insect.Name);
        string[] pictures = plan.IsDrawn ? [k_Strip, k_Map] : [], files = [.. pictures, k_Glb, k_Joints, k_Forces, k_Span, k_Summary];
        using var folder = OutputFolder.Prepare(path, files);
        var terminal = new Terminal(output);
        FlightSummary summary = null;
        terminal.ShowProgress(flight.Steps, (steps, stage) =>
        {
            FlightRecord record = flight.Run(steps);
            stage("measuring");
            summary = FlightSummary.Of(record);
            if (plan.IsDrawn)
            {
                stage("drawing");
                folder.Write(k_Strip, stream => stream.Write(BeatStrip.Draw(record)));
                folder.Write(k_Map, stream => stream.Write(StretchMap.Draw(record)));
            }

            stage("writing");
            folder.Write(k_Glb, stream => WingsGlb.Write(record, stream));
            folder.Write(k_Joints, stream => CsvTable.Write(stream, JointTable.Of(record)));
            folder.Write(k_Forces, stream => CsvTable.Write(stream, ForceTable.Of(record)));
            folder.Write(k_Span, stream => CsvTable.Write(stream, SpanwiseTable.Of(record)));
            folder.Write(k_Summary, stream => SummaryJson.Write(summary, stream));
        });
        folder.Commit();
        terminal.ShowSummary(summary, path, files);
    }
}
