namespace Alate.Cli;

/// <summary>A number that can be changed before a flight: one of a species' sliders, or one of the flight itself.</summary>
internal sealed class FlownParameter
{
    /// <summary>Reference to the number in a preset.</summary>
    public delegate ref float Field(WingPreset preset);

    private readonly Func<FlightPlan, double, FlightPlan> m_Planned;

    /// <summary>A number of the species.</summary>
    public FlownParameter(string name, string unit, float min, float max, Field field)
        : this(name, unit, Typed(min), Typed(max))
    {
        Of = field;
        m_Planned = (plan, value) => plan with { Change = new ParameterChange(this, (float)value) };
    }

    /// <summary>A number of the flight.</summary>
    public FlownParameter(
        string name, string unit, double min, double max, Func<FlightPlan, double, FlightPlan> planned, bool isWhole = false)
        : this(name, unit, min, max)
    {
        m_Planned = planned;
        IsWhole = isWhole;
    }

    private FlownParameter(string name, string unit, double min, double max)
    {
        Name = name;
        Unit = unit;
        Min = min;
        Max = max;
    }

    /// <summary>The slider's name, lower case with hyphens.</summary>
    public string Name { get; }

    /// <summary>Empty for a ratio.</summary>
    public string Unit { get; }

    public double Min { get; }

    public double Max { get; }

    /// <summary>Null for a number of the flight.</summary>
    public Field Of { get; }

    public bool IsWhole { get; }

    /// <summary>Name and unit.</summary>
    public string Title => Unit.Length == 0 ? Name : $"{Name}, {Unit}";

    // As a user types it: 0.1, not 0.10000000149.
    private static double Typed(float bound) =>
        double.Parse(bound.ToString("R", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    /// <summary>The plan with this number at a value.</summary>
    public FlightPlan In(FlightPlan plan, double value) => m_Planned(plan, value);

    /// <summary>
    /// Gives the first wing of an insect the value, and moves the others along: by the same factor, or by the same difference where the
    /// number may be negative or was zero.
    /// </summary>
    public void Set(IReadOnlyList<WingPreset> wings, float value)
    {
        float before = Of(wings[0]);
        foreach (WingPreset wing in wings)
        {
            ref float field = ref Of(wing);
            field = Min < 0 || before == 0f ? field + (value - before) : field * (value / before);
        }

        Of(wings[0]) = value;
    }
}
