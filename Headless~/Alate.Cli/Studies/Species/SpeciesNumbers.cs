namespace Alate.Cli;

/// <summary>Every number of a species.</summary>
internal sealed record SpeciesNumbers(InsectDefinition Definition, IReadOnlyList<WingNumbers> Wings)
{
    public static SpeciesNumbers Of(InsectDefinition definition) => new(definition, definition.Wings.Select(WingNumbers.Of).ToList());
}
