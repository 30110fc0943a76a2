namespace Alate.Cli;

/// <summary>Substeps of a beat at which a row is flown.</summary>
/// <param name="Substeps">Of the row's value.</param>
/// <param name="Fine">Of its limit.</param>
internal readonly record struct Fineness(int Substeps, int Fine)
{
    /// <summary>Those of the report.</summary>
    public static Fineness Report { get; } = new(DragonflyRows.Substeps, DragonflyRows.FineSubsteps);
}
