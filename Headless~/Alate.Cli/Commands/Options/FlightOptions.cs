using System.CommandLine;

namespace Alate.Cli;

/// <summary>Options that several commands have.</summary>
internal static class FlightOptions
{
    /// <summary>Names of species; none stands for all of them.</summary>
    public static Argument<string[]> AnySpecies() => new("SPECIES")
    {
        Arity = ArgumentArity.ZeroOrMore,
        Description = $"The insects: {KnownSpecies.Names}; all where none is named.",
    };

    public static Option<double?> Speed() => Numbers.Optional(FlightNumbers.Speed);

    public static Option<int?> Substeps() => Numbers.OptionalCount(FlightNumbers.Substeps);

    public static Option<InsectVariant?> Variant() => Choice.Optional<InsectVariant>(
        "--variant", "Which numbers of the species: the tables', measured ones where there are any, softer ones, or those with which its "
            + "wings carry it. [default: standard]", new()
            {
                ["standard"] = InsectVariant.Standard,
                ["biological"] = InsectVariant.Biological,
                ["expressive"] = InsectVariant.Expressive,
                ["flight"] = InsectVariant.Flight,
            });

    /// <summary>A wall behind what a picture shows.</summary>
    public static Option<BackdropLook?> Backdrop(string what) => Choice.Optional<BackdropLook>(
        "--backdrop", $"A wall behind {what}, on which shadows fall: bright, or dim for pale wings. [default: paper]", new()
        {
            ["studio"] = BackdropLook.Studio,
            ["dark"] = BackdropLook.Dark,
        });

    public static Option<PictureView?> View() => Choice.Optional(
        "--view", "The side the picture shows. [default: front-left]", PictureView.ByName);
}
