namespace Alate.Cli;

/// <summary>Charts and diagrams of the manual; on the page of the model what the paper draws in its figures 3 to 6.</summary>
internal static class ManualFigures
{
    /// <summary>Colours of curves; their looks differ too.</summary>
    internal static string Blue => ChartSheet.Colours[0];

    /// <inheritdoc cref="Blue"/>
    internal static string Orange => ChartSheet.Colours[1];

    /// <inheritdoc cref="Blue"/>
    internal const string Grey = "#6b6455", Green = "#3f7d3a";

    /// <summary>Files in the documentation's folder, with what draws each as SVG.</summary>
    public static IReadOnlyList<(string Name, Func<string> Draw)> Pictures { get; } =
    [
        ("images/model-skeletons.svg", SkeletonFigure.Draw),
        ("images/model-motion.svg", MotionFigure.Draw),
        ("images/model-delays.svg", DelayFigure.Draw),
        ("images/model-clock.svg", ClockFigure.Draw),
        ("images/model-coefficients.svg", CoefficientFigure.Draw),
        ("images/kinematics.svg", KinematicsFigure.Draw),
        ("images/hum.svg", HumFigure.Draw),
        ("images/skeleton-tool.svg", OverlayFigure.Draw),
    ];

    /// <summary>Points of a curve at even places from 0 to a value.</summary>
    internal static List<ChartPoint> Curve(double to, int steps, Func<double, double> of) =>
        [.. Enumerable.Range(0, steps + 1).Select(k => new ChartPoint(to * k / steps, of(to * k / steps)))];
}
