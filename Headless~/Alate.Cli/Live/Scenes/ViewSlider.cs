namespace Alate.Cli;

/// <summary>A number that the page can change while the insect flies.</summary>
/// <param name="Name">Its name in messages.</param>
/// <param name="Title">Its name on the page.</param>
/// <param name="Unit">Empty for a plain number.</param>
/// <param name="Min">Least.</param>
/// <param name="Max">Most.</param>
/// <param name="IsLogarithmic">Equal ways of the slider are equal ratios.</param>
/// <param name="IsWhole">Whole numbers alone.</param>
/// <param name="Of">Reads it.</param>
/// <param name="With">Settings with another value of it.</param>
internal sealed record ViewSlider(
    string Name, string Title, string Unit, double Min, double Max, bool IsLogarithmic, bool IsWhole, Func<ViewSettings, double> Of,
    Func<ViewSettings, double, ViewSettings> With)
{
    /// <summary>The only one that needs no simulation.</summary>
    public static ViewSlider SlowMotion => All[0];

    /// <summary>All sliders in the order of the page.</summary>
    public static IReadOnlyList<ViewSlider> All { get; } =
    [
        new("slow", "slow motion", "× time", 0.001, 1, true, false, settings => settings.Slow,
            (settings, value) => settings with { Slow = value }),
        For(FlightNumbers.Speed), For(FlightNumbers.Wind), For(FlightNumbers.Elasticity), For(FlightNumbers.Lag),
        For(FlightNumbers.Amplitude),
        For(FlightNumbers.Frequency), For(FlightNumbers.Substeps),
    ];

    /// <summary>Settings with a value that a message names.</summary>
    /// <exception cref="UserException">There is no such slider, or the value is out of its range.</exception>
    public static ViewSettings Set(ViewSettings settings, string name, double value)
    {
        foreach (ViewSlider slider in All)
        {
            if (slider.Name != name)
                continue;
            if (!(value >= slider.Min && value <= slider.Max))
            {
                throw new UserException(
                    FormattableString.Invariant($"'{name}' must lie between {slider.Min} and {slider.Max}; it is {value}."));
            }
            return slider.With(settings, slider.IsWhole ? Math.Round(value) : value);
        }

        throw new UserException($"There is no slider {Quote.Of(name)}.");
    }

    private static ViewSlider For(FlightNumber number) => new(
        number.Slider.Name, number.Slider.Title, number.Slider.Unit, number.Slider.Min, number.Slider.Max,
        number.Slider.IsLogarithmic, number.IsWhole,
        settings => number.Of(settings.Flight), (settings, value) => settings with { Flight = number.In(settings.Flight, value) });
}
