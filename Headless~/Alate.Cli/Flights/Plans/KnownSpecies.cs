namespace Alate.Cli;

/// <summary>Species and variants by the names that users type: of the catalogue, or files of their own insects.</summary>
internal static class KnownSpecies
{
    /// <summary>List of what an argument takes, for the help.</summary>
    public static string Names => $"{string.Join(", ", InsectCatalogue.Names)}, or a file NAME{InsectFile.Ending}";

    /// <summary>The species of the catalogue or the insect file that an argument names.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are, or names the place in the file.</exception>
    public static InsectDefinition Find(string argument) =>
        IsFile(argument) ? InsectFile.Read(argument, InputFiles.Instance) : FindInCatalogue(argument);

    /// <summary>Returns true for an argument that names a file, not an insect of the catalogue.</summary>
    public static bool IsFile(string argument) => argument != null && argument.EndsWith(".json", StringComparison.OrdinalIgnoreCase);

    /// <summary>The species of a name.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are.</exception>
    public static InsectDefinition FindInCatalogue(string name) => InsectCatalogue.TryFind(name, out InsectDefinition definition)
        ? definition
        : throw new UserException($"Unknown species {Quote.Of(name)}. Known: {string.Join(", ", InsectCatalogue.Names)}.");

    /// <summary>The species of a name that has a variant.</summary>
    /// <exception cref="UserException">There is no such species, or it has no such variant; the message lists those there are.</exception>
    public static InsectDefinition Find(string name, InsectVariant variant) => With(Find(name), variant);

    /// <summary>A species, checked to have a variant.</summary>
    /// <exception cref="UserException">It has no such variant; the message lists those there are.</exception>
    public static InsectDefinition With(InsectDefinition definition, InsectVariant variant) =>
        definition.Variants.Contains(variant)
            ? definition
            : throw new UserException(
                $"There is no {Word(variant)} {definition.Name}. It has: {string.Join(", ", definition.Variants.Select(Word))}.");

    /// <summary>The species of the catalogue with another insect, which comes before one of its name.</summary>
    public static IEnumerable<InsectDefinition> With(InsectDefinition other) => InsectCatalogue.All.Contains(other)
        ? InsectCatalogue.All
        : InsectCatalogue.All.Where(species => species.Name != other.Name).Prepend(other);

    /// <summary>The species that are named, each once, or all that have the variant where none is.</summary>
    /// <exception cref="UserException">There is no such species, or it has no such variant; the message lists those there are.</exception>
    public static List<InsectDefinition> FindAny(string[] names, InsectVariant variant) => names.Length == 0
        ? InsectCatalogue.All.Where(species => species.Variants.Contains(variant)).ToList()
        : FindEach(names).ConvertAll(species => With(species, variant));

    /// <summary>The species that are named, each once.</summary>
    /// <exception cref="UserException">There is no such species, or two have one name.</exception>
    public static List<InsectDefinition> FindEach(IEnumerable<string> names)
    {
        var found = names.Distinct().Select(Find).Distinct().ToList();
        string twice = found.GroupBy(species => species.Name).FirstOrDefault(group => group.Count() > 1)?.Key;
        return twice == null
            ? found
            : throw new UserException($"Two of these insects are called '{twice}', by which files are named; give one another \"name\".");
    }

    /// <summary>Name of a variant on the command line.</summary>
    public static string Word(InsectVariant variant) => variant.ToString().ToLowerInvariant();

    /// <summary>A heading with the variant where that is not the standard one.</summary>
    public static string Titled(string heading, InsectVariant variant) =>
        variant == InsectVariant.Standard ? heading : $"{heading}, {Word(variant)}";
}
