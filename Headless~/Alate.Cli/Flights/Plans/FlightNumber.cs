namespace Alate.Cli;

/// <summary>A number of a flight, described once: options, parameters of a sweep, sliders and messages are made of it.</summary>
/// <param name="Name">Name of the option without its hyphens, and of the parameter of a sweep.</param>
/// <param name="Min">The least that it takes.</param>
/// <param name="Max">The most that it takes; of a vector, either way.</param>
internal sealed record FlightNumber(string Name, double Min, double Max)
{
    private const string k_Range = "{range}";

    private readonly string m_Help = "";

    /// <summary>The option's name.</summary>
    public string Option => "--" + Name;

    /// <summary>Word for its value in the help: the unit in capitals, or a letter.</summary>
    public string Word { get; init; }

    /// <summary>Text of the help; <c>{range}</c> in it stands for the least and the most.</summary>
    public string Help
    {
        get => m_Help.Replace(k_Range, FormattableString.Invariant($"{Min} to {Max}"));
        init => m_Help = value;
    }

    /// <summary>Value where none is given, or where the option stands without one; 0 where the flight's other numbers say it.</summary>
    public double Default { get; init; }

    /// <summary>Unit on the axis of a sweep; empty for a plain number.</summary>
    public string Unit { get; init; } = "";

    /// <summary>True for whole numbers alone.</summary>
    public bool IsWhole { get; init; }

    /// <summary>Reads it in a plan of a flight on the spot; null for a number of a free one.</summary>
    public Func<FlightPlan, double> Of { get; init; }

    /// <summary>The plan with another value of it.</summary>
    public Func<FlightPlan, double, FlightPlan> In { get; init; }

    /// <summary>Slider on the page; null for none.</summary>
    public FlightSlider Slider { get; init; }

    /// <summary>The number as a sweep changes it.</summary>
    public FlownParameter Swept(string name = null) => new(name ?? Name, Unit, Min, Max, In, IsWhole);
}
