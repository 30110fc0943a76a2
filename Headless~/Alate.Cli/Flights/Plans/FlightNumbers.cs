namespace Alate.Cli;

/// <summary>Numbers of flights on the spot, and of free ones.</summary>
internal static class FlightNumbers
{
    /// <summary>Fastest a flight or its wind may be in any direction, m/s, and steepest pitch up or down, degrees.</summary>
    private const double k_MostSpeed = 100, k_MostPitch = 90;

    public static FlightNumber Speed { get; } = new("speed", 0, k_MostSpeed)
    {
        Word = "M/S",
        Unit = "m/s",
        Help = "Speed of the body ahead, metres per second, {range}. [default: 0.65 of the species' top speed, an insect's 1.3]",
        Of = plan => plan.Speed,
        In = (plan, value) => plan with { Speed = value },
        Slider = new("speed", "speed", "m/s", 0, 5),
    };

    public static FlightNumber Climb { get; } = new("climb", -k_MostSpeed, k_MostSpeed)
    {
        Word = "M/S",
        Unit = "m/s",
        Help = "Speed of the body up, metres per second, {range}; negative sinks.",
        Of = plan => plan.Climb,
        In = (plan, value) => plan with { Climb = value },
    };

    public static FlightNumber Pitch { get; } = new("pitch", -k_MostPitch, k_MostPitch)
    {
        Word = "DEG",
        Unit = "°",
        Help = "Pitch of the body, degrees, nose up positive, {range}.",
        Of = plan => plan.PitchDegrees,
        In = (plan, value) => plan with { PitchDegrees = value },
    };

    public static FlightNumber Seconds { get; } = new("seconds", 0, 3600)
    {
        Word = "S",
        Help = "Simulated time, seconds, one beat to an hour; its last beat is reported. [default: 8 beats]",
    };

    /// <summary>An option takes a vector; a sweep and the page take what comes from ahead.</summary>
    public static FlightNumber Wind { get; } = new("wind", -k_MostSpeed, k_MostSpeed)
    {
        Word = "X,Y,Z",
        Unit = "m/s from ahead",
        Help = "Wind, metres per second, each {range}: to the right, up, ahead. [default: 0,0,0]",
        Of = plan => 0 - plan.Wind[2],
        In = (plan, value) => plan with { Wind = [0, 0, -value] },
        Slider = new("wind", "head wind", "m/s", -5, 5),
    };

    /// <summary>Its default is that of the option without a value.</summary>
    public static FlightNumber Induced { get; } = new("induced-flow", 0, InducedFlow.MostFactor)
    {
        Word = "FACTOR",
        Help = "Wings that meet the air which they draw along, by momentum theory, times a wake factor, {range}. "
            + "[default: none; 1 without FACTOR]",
        Default = 1,
    };

    public static FlightNumber Lag { get; } = new("lag", WingBounds.ChordDelay.Min, WingBounds.ChordDelay.Max)
    {
        Word = "LAMBDA",
        Help = "Delay of the trailing edge, half beats, {range}. [default: the species']",
        Of = plan => plan.Lag ?? 0,
        In = (plan, value) => plan with { Lag = value },
        Slider = new("delay", "delay of the trailing edge", "half beats", 0, 1),
    };

    /// <summary>Its range is that of the option, whatever the species.</summary>
    public static FlightNumber Elasticity { get; } = new("elasticity", 0.001, 1e6)
    {
        Word = "FACTOR",
        Unit = "× the species'",
        Help = "Factor on the species' elasticity, {range}; below 1 is softer.",
        Default = 1,
        Of = plan => plan.Elasticity,
        In = (plan, value) => plan with { Elasticity = value },
        Slider = new("elasticity", "elasticity", "×", 0.1, 10, IsLogarithmic: true),
    };

    public static FlightNumber Amplitude { get; } = new("amplitude", 0, 2)
    {
        Default = 1,
        Of = plan => plan.Amplitude,
        In = (plan, value) => plan with { Amplitude = value },
        Slider = new("amplitude", "amplitude", "×", 0, 1.5),
    };

    public static FlightNumber Frequency { get; } = new("frequency", 0.25, 2)
    {
        Default = 1,
        Of = plan => plan.Frequency,
        In = (plan, value) => plan with { Frequency = value },
        Slider = new("frequency", "frequency", "×", 0.25, 2, IsLogarithmic: true),
    };

    public static FlightNumber Substeps { get; } = new("substeps", WingParameters.MinSubsteps, WingParameters.MaxSubsteps)
    {
        Word = "N",
        IsWhole = true,
        Help = "Substeps of a beat, {range}. [default: the species']",
        Of = plan => plan.Substeps ?? 0,
        In = (plan, value) => plan with { Substeps = (int)value },
        Slider = new("substeps", "substeps of a beat", "", WingParameters.MinSubsteps, WingParameters.MaxSubsteps, IsLogarithmic: true),
    };

    /// <summary>A place to fly to.</summary>
    public static FlightNumber To { get; } = new("to", -1000, 1000)
    {
        Word = "X,Y,Z",
        Help = "With --free: a place to fly to, metres from the start: right, up, ahead.",
    };

    public static FlightNumber Seed { get; } = new("seed", 1, int.MaxValue)
    {
        Word = "N",
        IsWhole = true,
        Help = "With --free: seed of the track of --pilot wander. [default: 1]",
        Default = 1,
    };

    public static FlightNumber Erratic { get; } = new("erratic", 0, 1)
    {
        Word = "E",
        Help = "With --free: liveliness of the track of --pilot wander, {range}.",
    };

    public static FlightNumber Gust { get; } = new("gust", -20, 20)
    {
        Word = "X,Y,Z",
        Help = "With --free: a gust of one second in the middle of the flight, metres per second.",
    };

    public static FlightNumber Aid { get; } = new("aid", 0, 1)
    {
        Word = "A",
        Help = "With --free: help from outside after a tumble, {range}.",
    };

    /// <summary>Step of a free flight.</summary>
    public static FlightNumber Step { get; } = new("step", 0.001, 0.05)
    {
        Word = "S",
        Help = "With --free: step of the game, seconds, {range}.",
        Default = 0.02,
    };
}
