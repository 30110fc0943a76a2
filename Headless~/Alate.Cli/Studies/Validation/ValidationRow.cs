namespace Alate.Cli;

/// <summary>One comparison with something published.</summary>
/// <param name="Record">What was measured or computed by others: an animal and its flight, a wing, a beam.</param>
/// <param name="Quantity">What of it is compared, with its unit.</param>
/// <param name="Low">Least value that agrees; −∞ for none.</param>
/// <param name="High">Largest value that agrees; ∞ for none.</param>
/// <param name="Published">The published value, and whether it was measured or computed.</param>
/// <param name="Band">Where the band is from, in words; empty where there is none.</param>
/// <param name="Source">Where the value was published.</param>
/// <param name="Ours">The model's value.</param>
/// <param name="Fine">The model's value at twice the substeps; not a number where it has none.</param>
internal sealed record ValidationRow(string Record, string Quantity, double Low, double High, string Published, string Band, string Source,
    double Ours, double Fine)
{
    /// <summary>Largest change to twice the substeps that counts as converged.</summary>
    public const double Converged = 0.03;

    /// <summary>The same over the width of the band.</summary>
    public const double OfBand = 0.2;

    /// <summary>The table where it stands.</summary>
    public ValidationTable Table { get; init; }

    /// <summary>Difference from the best physics of the report; null for none.</summary>
    public string Variant { get; init; }

    /// <summary>Why the row does not count although it is of the best physics; null where it counts.</summary>
    public string Reason { get; init; }

    /// <summary>Values that it has where a term is switched or a number changed.</summary>
    public IReadOnlyList<ValidationExperiment> Experiments { get; init; } = [];

    /// <summary>Record, variant and quantity.</summary>
    public string Title => Variant == null ? $"{Record}: {Quantity}" : $"{Record}, {Variant}: {Quantity}";

    /// <summary>True where it counts: an insect's, of the best physics, with a band of a source.</summary>
    public bool IsCounted => Table == ValidationTable.Insects && Variant == null && Reason == null;

    /// <summary>True where there is a band to lie in.</summary>
    public bool HasBand => Band.Length > 0 && (double.IsFinite(Low) || double.IsFinite(High));

    /// <summary>Best value there is.</summary>
    public double Value => double.IsNaN(Fine) ? Ours : Fine;

    /// <summary>True where the value agrees.</summary>
    public bool IsInside => HasBand && Contains(Value);

    /// <summary>Distance from the band, in the row's unit; 0 inside.</summary>
    public double Distance => !HasBand || IsInside ? 0 : Value < Low ? Value - Low : Value - High;

    /// <summary>True where the value hardly changes with the substeps: by little of itself, or of the band.</summary>
    public bool IsConverged => Change <= Converged || (HasBand && Math.Abs(Ours - Fine) <= OfBand * (High - Low));

    /// <summary>Verdict in words.</summary>
    public string Verdict => !HasBand ? "–"
        : IsInside ? "inside" : FormattableString.Invariant($"outside by {Distance:0.00}").Replace('-', '−');

    /// <summary>Change to twice the substeps over the value there; not a number where there is none.</summary>
    public double Change => Math.Abs(Ours - Fine) / Math.Max(Math.Abs(Fine), 1e-9);

    /// <summary>True where a value lies in the band.</summary>
    public bool Contains(double value) => value >= Low && value <= High;
}
