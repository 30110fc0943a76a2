namespace Alate.Cli;

/// <summary>Flight that a study flies again and again, each time with other numbers.</summary>
internal abstract record StudyFlight
{
    /// <summary>Insect of it.</summary>
    public abstract InsectDefinition Insect { get; }

    /// <summary>Variant of the insect.</summary>
    public abstract InsectVariant Variant { get; }

    /// <summary>Names of all measures, as a message lists them.</summary>
    public abstract string KnownMeasures { get; }

    /// <summary>Returns the flight of an insect with other numbers.</summary>
    public abstract StudyFlight Of(InsectDefinition insect);

    /// <summary>Returns the flight with another value of a number of its own.</summary>
    /// <param name="key">Name of the number.</param>
    /// <param name="value">The value.</param>
    /// <exception cref="UserException">It is out of range, or nothing of this flight.</exception>
    public abstract StudyFlight With(string key, double value);

    /// <summary>Name and unit of a measure for charts; null where there is none.</summary>
    public abstract string TitleOf(string measure);

    /// <summary>Reads all that a flight reads, such as a prescribed motion.</summary>
    /// <exception cref="UserException">It cannot be flown.</exception>
    public abstract void Check();

    /// <summary>Flies, and measures.</summary>
    /// <param name="measures">Their names.</param>
    /// <exception cref="UserException">It cannot be flown.</exception>
    public abstract double[] Fly(IReadOnlyList<string> measures);

    /// <summary>Throws where a value is out of a number's range.</summary>
    protected static double Within(FlightNumber number, string key, double value) => value >= number.Min && value <= number.Max
        ? value
        : throw new UserException(FormattableString.Invariant($"'{key}' must lie between {number.Min} and {number.Max}; it is {value}."));
}
