using Alate.Flight;

namespace Alate.Cli;

/// <summary>Flies a plan freely, shows how it gets on, and writes what came of it: all of the files or none.</summary>
internal static class FreeReport
{
    private const string k_Trajectory = "trajectory.csv", k_Forces = "forces.csv", k_Path = "path.png", k_Glb = "flight.glb",
        k_Summary = "summary.json";

    /// <exception cref="UserException">Anything the user can mend; nothing has been written then.</exception>
    public static void Run(FreePlan plan, TextWriter output)
    {
        string path = plan.Folder ?? Path.Combine("out", plan.Insect.Name + "-free");
        string[] pictures = plan.IsDrawn ? [k_Path] : [], files = [k_Trajectory, k_Forces, .. pictures, k_Glb, k_Summary];
        using var folder = OutputFolder.Prepare(path, files);
        if (plan.RecordFile != null)
            OutputFile.Check(plan.RecordFile);
        var terminal = new Terminal(output);
        FreeRecord record = null;
        float factor = 1f;
        terminal.ShowProgress(plan.Steps, (steps, stage) =>
        {
            record = FreeRun.Fly(plan, steps);
            if (plan.IsDrawn)
            {
                stage("drawing");
                folder.Write(k_Path, stream => stream.Write(PathPicture.Draw(record, out factor)));
            }

            stage("writing");
            folder.Write(k_Trajectory, stream => CsvTable.Write(stream, TrajectoryTable.Of(record)));
            folder.Write(k_Forces, stream => CsvTable.Write(stream, ForceTable.Of(record)));
            folder.Write(k_Glb, stream => WingsGlb.Write(record.Beat, stream, record));
            folder.Write(k_Summary, stream => FreeSummaryJson.Write(record, plan, stream));
        });
        if (plan.RecordFile != null)
            OutputFile.Write(plan.RecordFile, stream => stream.Write(Encoding.UTF8.GetBytes(RecordingText.Write(record.Recording))));
        folder.Commit();
        output.WriteLine(Way(record));
        output.WriteLine(Air(record));
        output.WriteLine(Tumbles(record.Tumbles));
        if (record.Missing != null)
            output.WriteLine(record.Missing);
        if (factor >= PathPicture.Larger)
            output.WriteLine(System.FormattableString.Invariant($"path.png shows the insect {factor:0.#} times larger than its way."));
        if (plan.Replay is { } replay)
            output.WriteLine(Replayed(replay.Recording));
        if (plan.RecordFile != null)
            output.WriteLine($"{plan.RecordFile} has the flight for --replay.");
        terminal.ShowFiles(path, files);
    }

    internal static string Way(FreeRecord record)
    {
        FreeMoment last = record.Moments[^1];
        double error = record.VelocityError;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{record.Insect.DisplayName}: {last.Time:0.##} s by its own wings, from the origin to "
            + $"{last.Position.x:0.00}, {last.Position.y:0.00}, {last.Position.z:0.00} m; "
            + $"velocity off by {error:0.000} m/s (bob and all)");
    }

    internal static string Air(FreeRecord record) => string.Create(
        CultureInfo.InvariantCulture,
        $"mean lift {record.Moments.Average(at => at.Force.y) / record.Weight:0.000} of the weight, "
        + $"{100 * record.UpstrokeShare:0} % of it on the upstroke; "
        + $"power {1e3 * record.Moments.Average(at => at.Power):0.###} mW; "
        + $"aid {1e3 * record.Moments.Average(at => at.AidPower):0.###} mW");

    internal static string Tumbles(IReadOnlyList<FlightTumble> tumbles)
    {
        if (tumbles.Count == 0)
            return "it did not tumble";
        FlightTumble longest = tumbles.MaxBy(tumble => tumble.seconds);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"it tumbled {(tumbles.Count == 1 ? "once" : $"{tumbles.Count} times")}, "
            + $"{tumbles.Sum(tumble => tumble.seconds):0.00} s in all; the longest time at {longest.time:0.00} s, "
            + $"for {longest.seconds:0.00} s and {longest.distance:0.00} m");
    }

    private static string Replayed(FlightRecording recording) => recording.Package == PackageRoot.Version
        ? "Flown again from its recording: the same to the bit on the same kind of processor."
        : $"Flown again from its recording, by version {PackageRoot.Version}; it was made by "
            + $"{(recording.Package.Length > 0 ? recording.Package : "a scene")}, whose flight may differ.";
}
