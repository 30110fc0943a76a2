using Alate.Wake;

namespace Alate.Cli;

/// <summary>Plan of a wake behind a flight on the spot.</summary>
internal sealed record WakePlan
{
    public WakeMethod Method { get; init; }

    /// <summary>Beats from rest; the loads are those of the last one.</summary>
    public int Beats { get; init; } = 3;

    /// <summary>Flights, each but the first with the air of the wakes before replayed at the wings.</summary>
    public int Rounds { get; init; } = 1;

    public int StepsPerBeat { get; init; } = 24;

    /// <summary>True where the insect flies by its trim at the speed and climb of the flight.</summary>
    public bool IsFree { get; init; }

    /// <summary>Panels along the chord; null is the method's default.</summary>
    public int? ChordPanels { get; init; }

    public int SpanPanels { get; init; } = 10;

    /// <summary>Age at which a row of the wake is dropped, beats.</summary>
    public double Keep { get; init; } = 2;

    /// <summary>Height of the middle of the thorax above a ground, metres; null for none.</summary>
    public double? Ground { get; init; }

    /// <summary>Metres from the middle of the thorax to the plane behind it; null is the length of a wing.</summary>
    public double? Plane { get; init; }

    /// <summary>True where the rings are shown.</summary>
    public bool IsDrawn { get; init; } = true;

    /// <summary>True for cores as wide as a chord.</summary>
    public bool HasWideCores { get; init; }

    /// <summary>Radius of an old core, chords; null is the default.</summary>
    public double? FarCore { get; init; }

    /// <summary>[kind of wing] Factor on the chords, for wings of a published area.</summary>
    public IReadOnlyList<double> Chords { get; init; }

    /// <summary>Density of the fluid, kg/m³; null is the preset's.</summary>
    public double? Density { get; init; }

    /// <summary>Part of a wake that the coefficients hold; it is taken out.</summary>
    public MeasuredDownwash Downwash { get; init; }
}
