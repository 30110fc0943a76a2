using System.CommandLine;
using Alate.Cli.Pictures;

namespace Alate.Cli.Commands;

/// <summary>Options that several commands have.</summary>
internal static class FlightOptions
{
    public static Option<double?> Speed() => Numbers.Optional(
        "--speed", "M/S", 0, 100,
        "Speed of the body ahead, metres per second, 0 to 100. [default: 0.65 of the species' top speed, an insect's 1.3]");

    public static Option<SpeciesVariant?> Variant() => Choice.Optional<SpeciesVariant>(
        "--variant", "Which numbers of the species: the tables', measured ones where there are any, or softer ones. [default: standard]", new()
        {
            ["standard"] = SpeciesVariant.Standard, ["biological"] = SpeciesVariant.Biological, ["expressive"] = SpeciesVariant.Expressive,
        });

    public static Option<PictureView?> View() => Choice.Optional(
        "--view", "The side the picture shows. [default: front-left]", PictureView.ByName);

    /// <summary>The species of a name.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are.</exception>
    public static SpeciesDefinition Find(string name) => Species.TryFind(name, out SpeciesDefinition definition)
        ? definition
        : throw new UserException($"Unknown species '{name}'. Known: {string.Join(", ", Species.Names)}.");
}
