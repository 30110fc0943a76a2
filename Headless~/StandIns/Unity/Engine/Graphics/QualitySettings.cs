namespace UnityEngine;

public sealed class QualitySettings : Object
{
    private QualitySettings()
    {
    }

    public static float lodBias { get; set; } = 1f;

    /// <summary>Distance from the camera up to which the built-in pipeline draws shadows.</summary>
    public static float shadowDistance { get; set; } = 40f;
}
