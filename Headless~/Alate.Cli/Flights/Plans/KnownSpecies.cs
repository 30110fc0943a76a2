namespace Alate.Cli;

/// <summary>Species and variants by the names that users type.</summary>
internal static class KnownSpecies
{
    /// <summary>The species of a name.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are.</exception>
    public static InsectDefinition Find(string name) => InsectCatalogue.TryFind(name, out InsectDefinition definition)
        ? definition
        : throw new UserException($"Unknown species {Quote.Of(name)}. Known: {string.Join(", ", InsectCatalogue.Names)}.");

    /// <summary>The species of a name that has a variant.</summary>
    /// <exception cref="UserException">There is no such species, or it has no such variant; the message lists those there are.</exception>
    public static InsectDefinition Find(string name, InsectVariant variant)
    {
        InsectDefinition definition = Find(name);
        return definition.Variants.Contains(variant)
            ? definition
            : throw new UserException(
                $"There is no {Word(variant)} {definition.Name}. It has: {string.Join(", ", definition.Variants.Select(Word))}.");
    }

    /// <summary>The species that are named, each once, or all that have the variant where none is.</summary>
    /// <exception cref="UserException">There is no such species, or it has no such variant; the message lists those there are.</exception>
    public static List<InsectDefinition> FindAny(string[] names, InsectVariant variant) => names.Length == 0
        ? InsectCatalogue.All.Where(species => species.Variants.Contains(variant)).ToList()
        : names.Select(name => Find(name, variant)).Distinct().ToList();

    /// <summary>Name of a variant on the command line.</summary>
    public static string Word(InsectVariant variant) => variant.ToString().ToLowerInvariant();

    /// <summary>A heading with the variant where that is not the standard one.</summary>
    public static string Titled(string heading, InsectVariant variant) =>
        variant == InsectVariant.Standard ? heading : $"{heading}, {Word(variant)}";
}
