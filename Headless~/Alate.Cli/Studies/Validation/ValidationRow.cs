namespace Alate.Cli;

/// <summary>One comparison with something measured or published.</summary>
/// <param name="Title">What is compared.</param>
/// <param name="Low">Least value that agrees; −∞ for none.</param>
/// <param name="High">Largest value that agrees; ∞ for none.</param>
/// <param name="Measured">The measured value or band in words.</param>
/// <param name="Source">Where it was published.</param>
/// <param name="Ours">The model's value.</param>
/// <param name="Fine">The model's value at twice the substeps; not a number where it has none.</param>
/// <param name="Cause">What is believed to be the cause where it does not agree.</param>
internal sealed record ValidationRow(
    string Title, double Low, double High, string Measured, string Source, double Ours, double Fine, string Cause)
{
    /// <summary>Largest change to twice the substeps that counts as converged.</summary>
    public const double Converged = 0.03;

    /// <summary>Best value there is.</summary>
    public double Value => double.IsNaN(Fine) ? Ours : Fine;

    /// <summary>True where the value agrees.</summary>
    public bool IsInside => Value >= Low && Value <= High;

    /// <summary>Distance from the band, in the row's unit; 0 inside.</summary>
    public double Distance => IsInside ? 0 : Value < Low ? Value - Low : Value - High;

    /// <summary>True where the value hardly changes with the substeps.</summary>
    public bool IsConverged => Change <= Converged;

    /// <summary>Verdict in words.</summary>
    public string Verdict => IsInside ? "inside" : FormattableString.Invariant($"outside by {Distance:0.00}").Replace('-', '−');

    /// <summary>Change to twice the substeps over the value there; not a number where there is none.</summary>
    public double Change => Math.Abs(Ours - Fine) / Math.Max(Math.Abs(Fine), 1e-9);
}
