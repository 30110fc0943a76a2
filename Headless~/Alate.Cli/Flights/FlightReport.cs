using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Alate.Cli.Output;
using Spectre.Console;

namespace Alate.Cli.Flights;

/// <summary>Flies a plan, shows progress and the summary, and writes all files or none.</summary>
internal static class FlightReport
{
    public static void Run(FlightPlan plan, string folder)
    {
        Insect insect = Insect.Of(plan);
        using var files = new OutputFolder(folder);
        Flight.Result result = Fly(plan, insect);
        List<KeyValuePair<string, object>> summary = Summarise(plan, insect, result);
        files.Write("strip.svg", stream => Text(stream, writer => StripPicture.Write(result.Record, writer)));
        files.Write("wings.glb", stream => GlbWriter.Write(result.Record, stream));
        files.Write("joints.csv", stream => Text(stream, writer => JointsCsv.Write(result.Record, writer)));
        files.Write("summary.json", stream => SummaryJson.Write(stream, summary));
        files.Commit();
        Show(summary);
        AnsiConsole.WriteLine($"Wrote strip.svg, wings.glb, joints.csv and summary.json into {files.Path}.");
    }

    private static Flight.Result Fly(FlightPlan plan, Insect insect)
    {
        if (!AnsiConsole.Profile.Capabilities.Interactive)
            return Flight.Run(plan, insect, _ => { });
        Flight.Result result = null;
        AnsiConsole.Progress().Start(context =>
        {
            ProgressTask task = context.AddTask($"Flying {insect.Name}", maxValue: 1.0);
            result = Flight.Run(plan, insect, done => task.Value = done);
        });
        return result;
    }

    private static List<KeyValuePair<string, object>> Summarise(FlightPlan plan, Insect insect, Flight.Result result)
    {
        BeatMeasurement m = result.Measurement;
        var summary = new List<KeyValuePair<string, object>>();
        void Add(string key, object value) => summary.Add(new(key, value));
        Add("species", insect.Name);
        Add("preset", plan.Preset.ToString().ToLowerInvariant());
        Add("speed_m_per_s", plan.Speed);
        Add("climb_m_per_s", plan.Climb);
        Add("pitch_deg", plan.PitchDegrees);
        Add("frequency_hz", result.Record.FrequencyHz);
        Add("twist_pp_deg", m.twistPeakToPeak);
        Add("camber_min_pct", m.camberMin);
        Add("camber_max_pct", m.camberMax);
        Add("tip_bend_pp_deg", m.tipBendPeakToPeak);
        Add("tip_bend_max_deg", m.tipBendMax);
        Add("lag_deg", m.lag);
        Add("edge_stretch_max_pct", m.edgeStretchMax);
        Add("edge_stretch_p99_pct", m.edgeStretchP99);
        Add("lift_over_weight", result.LiftOverWeight);
        Add("newton_iterations_mean", result.NewtonIterations);
        Add("resets", result.Resets);
        Add("us_per_substep", result.MicrosecondsPerSubstep);
        return summary;
    }

    private static void Show(List<KeyValuePair<string, object>> summary)
    {
        Table table = new Table().Border(TableBorder.Simple).AddColumn("measure").AddColumn(new TableColumn("value").RightAligned());
        foreach ((string key, object value) in summary)
            table.AddRow(Markup.Escape(key), Markup.Escape(Shown(value)));
        AnsiConsole.Write(table);
    }

    private static string Shown(object value) => value switch
    {
        float or double => Convert.ToDouble(value).ToString("0.###", CultureInfo.InvariantCulture),
        _ => Convert.ToString(value, CultureInfo.InvariantCulture),
    };

    private static void Text(Stream stream, Action<TextWriter> write)
    {
        using var writer = new StreamWriter(stream, leaveOpen: true) { NewLine = "\n" };
        write(writer);
    }
}
