using UnityEngine;

namespace StandIns;

/// <summary>What a test does to the screen.</summary>
internal sealed class ScreenAct(Event what)
{
    /// <summary>As the scripts see it.</summary>
    public Event Event { get; } = what;

    /// <summary>The text of what is pressed; null for nothing.</summary>
    public string Pressed { get; init; }

    /// <summary>How the label above the slider begins; null for no slider.</summary>
    public string Slid { get; init; }

    /// <summary>Where the slider is put.</summary>
    public float Value { get; init; }

    /// <summary>Whether the control was found that was meant.</summary>
    public bool WasFound { get; set; }

    /// <summary>Whether all was found that was to be found.</summary>
    public bool IsDone => WasFound || (Pressed == null && Slid == null);
}
