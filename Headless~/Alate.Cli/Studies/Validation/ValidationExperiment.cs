namespace Alate.Cli;

/// <summary>A row's value after one change: what of the difference to the published value that change explains.</summary>
/// <param name="Changed">The term that is switched or the number that is changed.</param>
/// <param name="Value">The row's value then.</param>
internal sealed record ValidationExperiment(string Changed, double Value);
