using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Light of the scene that is active, as it is in a new scene.</summary>
public sealed class RenderSettings : Object
{
    private RenderSettings()
    {
    }

    /// <summary>The sun as it was chosen; null for none.</summary>
    public static Light sun { get; set; }

    public static AmbientMode ambientMode { get; set; }
    public static Color ambientSkyColor { get; set; } = new(0.212f, 0.227f, 0.259f);
    public static Color ambientEquatorColor { get; set; } = new(0.114f, 0.125f, 0.133f);
    public static Color ambientGroundColor { get; set; } = new(0.047f, 0.043f, 0.035f);
}
