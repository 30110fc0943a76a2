namespace Alate.Cli;

/// <summary>Chart and table of accuracy of the documentation's page on wakes.</summary>
internal static class WakeFigures
{
    /// <summary>The page, in the documentation's folder.</summary>
    public const string Page = "wake.md";

    private const string k_Picture = "images/wake-accuracy.svg";

    /// <summary>All files, in the documentation's folder.</summary>
    public static IReadOnlyList<string> Files { get; } = [Page, k_Picture];

    /// <summary>Measures, draws, and writes the page's table again.</summary>
    /// <param name="page">The page as it is.</param>
    /// <returns>Each of <see cref="Files"/> with its text.</returns>
    public static IEnumerable<(string Name, string Text)> Make(string page) => Make(page, WakeAccuracy.Measure(() => { }));

    internal static IEnumerable<(string Name, string Text)> Make(string page, IReadOnlyList<WakeAccuracy> wakes) =>
    [
        (Page, PageBlock.Replace(page, "accuracy of wakes", MarkdownTable.Write(WakeAccuracyPicture.Table(wakes)))),
        (k_Picture, WakeAccuracyPicture.Draw(wakes)),
    ];
}
