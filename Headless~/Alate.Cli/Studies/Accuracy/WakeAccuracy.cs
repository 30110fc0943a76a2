using System.Diagnostics;
using Alate.Wake;

namespace Alate.Cli;

/// <summary>Fineness of a wake and what came of it.</summary>
/// <param name="Steps">Of a beat.</param>
/// <param name="Panels">Panels or strips along the span.</param>
/// <param name="ErrorPct">Distance of the mean force from that of the finest wake of its curve, % of the weight.</param>
/// <param name="Cost">Time over that of the default fineness.</param>
internal sealed record WakePoint(int Steps, int Panels, double ErrorPct, double Cost);

/// <summary>
/// Errors and costs of the wake of one flight over its steps and over its panels: each against a much finer run in that one direction, and
/// the default against one that is finer in both.
/// </summary>
internal sealed class WakeAccuracy
{
    private static readonly int[] s_Steps = [12, 16, 24, 36, 48], s_Panels = [4, 6, 8, 10, 12, 16];

    /// <summary>Finest runs.</summary>
    private const int k_FinestSteps = 96, k_FinestPanels = 24, k_BothSteps = 64;

    internal WakeAccuracy(string title) => Title = title;

    /// <summary>Name of flight and method.</summary>
    public string Title { get; }

    /// <summary>From coarse to fine, with the default panels.</summary>
    public List<WakePoint> OverSteps { get; } = [];

    /// <summary>From coarse to fine, with the default steps.</summary>
    public List<WakePoint> OverPanels { get; } = [];

    /// <summary>Distance of the default's mean force from that of a wake that is finer in both, % of the weight.</summary>
    public double DefaultErrorPct { get; internal set; }

    /// <summary>Sheds the wakes of a flight.</summary>
    /// <param name="title">Name of flight and method.</param>
    /// <param name="flight">The flight.</param>
    /// <param name="weight">By which forces are told, N.</param>
    /// <param name="method">Of the wake.</param>
    public static WakeAccuracy Of(string title, FlightRecord flight, double weight, WakeMethod method)
    {
        var made = new WakeAccuracy(title);
        made.Measure(flight, weight, new WakePlan { Method = method });
        return made;
    }

    private void Measure(FlightRecord flight, double weight, WakePlan plan)
    {
        var shed = new Dictionary<(int, int), (float3 Force, double Seconds)>();
        (float3 Force, double Seconds) Shed(int steps, int panels)
        {
            if (shed.TryGetValue((steps, panels), out (float3, double) before))
                return before;
            using var wake = new WakeFlight(flight, plan with { StepsPerBeat = steps, SpanPanels = panels });
            long start = Stopwatch.GetTimestamp();
            List<WakeMoment> beat = wake.Run(_ => { });
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            float3 sum = beat.Aggregate(default(float3), (all, at) => all + at.Force);
            return shed[(steps, panels)] = (sum / beat.Count, seconds);
        }

        // Compiled before it is timed.
        Shed(s_Steps[0], s_Panels[0]);
        (float3 usual, double cost) = Shed(plan.StepsPerBeat, plan.SpanPanels);
        double Off(float3 force, float3 finest) => 100 * math.distance(force, finest) / weight;
        (float3 force, _) = Shed(k_FinestSteps, plan.SpanPanels);
        foreach (int steps in s_Steps)
        {
            (float3 ours, double seconds) = Shed(steps, plan.SpanPanels);
            OverSteps.Add(new WakePoint(steps, plan.SpanPanels, Off(ours, force), seconds / cost));
        }

        (force, _) = Shed(plan.StepsPerBeat, k_FinestPanels);
        foreach (int panels in s_Panels)
        {
            (float3 ours, double seconds) = Shed(plan.StepsPerBeat, panels);
            OverPanels.Add(new WakePoint(plan.StepsPerBeat, panels, Off(ours, force), seconds / cost));
        }

        DefaultErrorPct = Off(usual, Shed(k_BothSteps, k_FinestPanels).Force);
    }
}
