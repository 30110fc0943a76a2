using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;
using Alate.Cli.Input;
using Alate.Cli.Pictures;

namespace Alate.Cli.Commands;

/// <summary>Options that several commands have.</summary>
internal static class FlightOptions
{
    /// <summary>Names of species; none stands for all of them.</summary>
    public static Argument<string[]> AnySpecies() => new("SPECIES")
    {
        Arity = ArgumentArity.ZeroOrMore,
        Description = $"The insects: {string.Join(", ", InsectCatalogue.Names)}; all where none is named.",
    };

    public static Option<double?> Speed() => Numbers.Optional(
        "--speed", "M/S", 0, PlanRange.MostSpeed,
        $"Speed of the body ahead, metres per second, 0 to {PlanRange.MostSpeed}. [default: 0.65 of the species' top speed, an insect's 1.3]");

    public static Option<int?> Substeps() => Numbers.OptionalCount(
        "--substeps", "N", WingParameters.MinSubsteps, WingParameters.MaxSubsteps,
        $"Substeps of a beat, {WingParameters.MinSubsteps} to {WingParameters.MaxSubsteps}. [default: the species']");

    public static Option<InsectVariant?> Variant() => Choice.Optional<InsectVariant>(
        "--variant", "Which numbers of the species: the tables', measured ones where there are any, softer ones, or those with which its wings carry it. [default: standard]", new()
        {
            ["standard"] = InsectVariant.Standard,
            ["biological"] = InsectVariant.Biological,
            ["expressive"] = InsectVariant.Expressive,
            ["flight"] = InsectVariant.Flight,
        });

    public static Option<PictureView?> View() => Choice.Optional(
        "--view", "The side the picture shows. [default: front-left]", PictureView.ByName);

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
            : throw new UserException($"There is no {Word(variant)} {definition.Name}. It has: {string.Join(", ", definition.Variants.Select(Word))}.");
    }

    /// <summary>The species of <see cref="AnySpecies"/>, each once: those that are named, or all that have the variant.</summary>
    /// <exception cref="UserException">There is no such species, or it has no such variant; the message lists those there are.</exception>
    public static List<InsectDefinition> FindAny(string[] names, InsectVariant variant) => names.Length == 0
        ? InsectCatalogue.All.Where(species => species.Variants.Contains(variant)).ToList()
        : names.Select(name => Find(name, variant)).Distinct().ToList();

    /// <summary>Name of a variant on the command line.</summary>
    public static string Word(InsectVariant variant) => variant.ToString().ToLowerInvariant();
}
