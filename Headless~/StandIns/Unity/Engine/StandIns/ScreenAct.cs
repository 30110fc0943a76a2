using UnityEngine;

namespace StandIns;

/// <summary>Act of a test on the screen.</summary>
internal sealed class ScreenAct(Event what)
{
    /// <summary>Event as the scripts see it.</summary>
    public Event Event { get; } = what;

    /// <summary>The text of what is pressed; null for nothing.</summary>
    public string Pressed { get; init; }

    /// <summary>Beginning of the label above the slider; null for no slider.</summary>
    public string Slid { get; init; }

    /// <summary>Value to which the slider is set.</summary>
    public float Value { get; init; }

    /// <summary>True once the meant control was found.</summary>
    public bool WasFound { get; set; }

    /// <summary>True once every control to be found was found.</summary>
    public bool IsDone => WasFound || (Pressed == null && Slid == null);
}
