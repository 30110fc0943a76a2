using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;

namespace Alate.Cli.Catalogue;

/// <summary>Every number of a species.</summary>
internal sealed record SpeciesNumbers(SpeciesDefinition Definition, IReadOnlyList<WingNumbers> Wings)
{
    public static SpeciesNumbers Of(SpeciesDefinition definition) => new(definition, definition.Wings.Select(WingNumbers.Of).ToList());
}
