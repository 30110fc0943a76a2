namespace Alate.Cli;

/// <summary>Pictures and tables of the documentation's page of accuracy: all species, standard variants.</summary>
internal static class AccuracyFigures
{
    /// <summary>The page, in the documentation's folder.</summary>
    public const string Page = "convergence.md";

    private const string k_Convergence = "images/convergence.svg", k_Wind = "images/wind.svg";

    /// <summary>All files, in the documentation's folder.</summary>
    public static IReadOnlyList<string> Files { get; } = [Page, k_Convergence, k_Wind];

    /// <summary>Measures, draws, and writes the page's tables again.</summary>
    /// <param name="page">The page as it is.</param>
    /// <returns>Each of <see cref="Files"/> with its text.</returns>
    public static IEnumerable<(string Name, string Text)> Make(string page)
    {
        var flights = InsectCatalogue.All.Select(species => FlightPlan.Cruise(species, InsectVariant.Standard)).ToList();
        return Make(page, SpeciesConvergence.Measure(new ConvergencePlan(flights), _ => { }),
            SpeciesWinds.Measure(new WindPlan(flights, WindPlan.DefaultSpeeds, false), _ => { }));
    }

    internal static IEnumerable<(string Name, string Text)> Make(
        string page, IReadOnlyList<SpeciesConvergence> errors, IReadOnlyList<SpeciesWinds> winds)
    {
        page = PageBlock.Replace(page, "errors", MarkdownTable.Write(AccuracyTable.Errors(errors)));
        page = PageBlock.Replace(page, "converged values", MarkdownTable.Write(AccuracyTable.Values(errors)));
        page = PageBlock.Replace(page, "winds", MarkdownTable.Write(AccuracyTable.Winds(winds)));
        return [(Page, page), (k_Convergence, ConvergencePicture.Draw(errors)), (k_Wind, WindPicture.Draw(winds, false))];
    }
}
