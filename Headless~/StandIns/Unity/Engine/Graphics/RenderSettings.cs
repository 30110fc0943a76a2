namespace UnityEngine;

/// <summary>Light of the scene that is active.</summary>
public sealed class RenderSettings : Object
{
    private RenderSettings()
    {
    }

    /// <summary>The sun as it was chosen; null for none.</summary>
    public static Light sun { get; set; }
}
