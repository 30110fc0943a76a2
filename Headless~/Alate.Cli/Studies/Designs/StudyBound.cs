namespace Alate.Cli;

/// <summary>A range in which a measure must lie.</summary>
/// <param name="Measure">Its name.</param>
/// <param name="Least">The least; −∞ for none.</param>
/// <param name="Most">The most; ∞ for none.</param>
internal sealed record StudyBound(string Measure, double Least, double Most)
{
    /// <summary>Distance of a value from the range over the size of its end; 0 within.</summary>
    public double MissedBy(double value) => value < Least ? (Least - value) / Size(Least) : value > Most ? (value - Most) / Size(Most) : 0;

    private static double Size(double end) => end == 0 ? 1 : Math.Abs(end);
}
