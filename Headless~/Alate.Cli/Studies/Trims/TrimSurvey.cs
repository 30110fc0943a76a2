using Alate.Flight;

namespace Alate.Cli;

/// <summary>Trims of an insect over speeds and climbs.</summary>
internal static class TrimSurvey
{
    /// <summary>Solves all; tells how many are done.</summary>
    /// <param name="model">The insect.</param>
    /// <param name="speeds">Speeds ahead, m/s.</param>
    /// <param name="climbs">Speeds up, m/s.</param>
    /// <param name="wake">Air that the wings meet; null for air at rest.</param>
    /// <param name="log">Receiver of each line.</param>
    public static List<TrimRow> Make(
        FlightModel model, IReadOnlyList<float> speeds, IReadOnlyList<float> climbs, ITrimWake wake, Action<string> log)
    {
        using var solver = new TrimSolver(model);
        using var grid = new TrimTable([.. speeds], [.. climbs]);
        var bake = new TrimBake(model) { Log = log, Wake = wake };
        TrimState[,] trims = bake.Trims(solver, grid);
        var rows = new List<TrimRow>();
        for (int s = 0; s < speeds.Count; s++)
        {
            for (int c = 0; c < climbs.Count; c++)
                rows.Add(Row(model, solver, new FlightCondition(speeds[s], climbs[c]), trims[s, c], bake.Problems[s, c]));
        }

        return rows;
    }

    private static TrimRow Row(FlightModel model, TrimSolver solver, FlightCondition condition, TrimState trim, string problem)
    {
        if (trim == null)
        {
            const double none = double.NaN;
            return new TrimRow(condition.Speed, condition.Climb, false, none, none, none, none, none, none, none, none, none, none, none,
                problem ?? "does not close");
        }

        double[] residual = solver.Residual(trim, condition, out double power);
        const double degree = Math.PI / 180;
        return new TrimRow(
            condition.Speed, condition.Climb, true, trim.Pitch / degree, trim.PitchBob / degree, trim.FrequencyScale * model.Frequency,
            2 * model.Wings[0].Parameters.amplitude.x / degree * trim.AmplitudeScale, trim.AmplitudeScale, trim.Tilt / degree,
            trim.MeanSweep / degree,
            1e3 * power, residual[0], residual[1], residual[2], null);
    }
}
