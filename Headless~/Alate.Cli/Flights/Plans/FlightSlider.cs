namespace Alate.Cli;

/// <summary>Looks of a number's slider on the page.</summary>
/// <param name="Name">Its name in messages.</param>
/// <param name="Title">Its name on the page.</param>
/// <param name="Unit">Empty for a plain number.</param>
/// <param name="Min">Least.</param>
/// <param name="Max">Most.</param>
/// <param name="IsLogarithmic">True where equal ways of the slider are equal ratios.</param>
internal sealed record FlightSlider(string Name, string Title, string Unit, double Min, double Max, bool IsLogarithmic = false);
