namespace UnityEngine;

public sealed class QualitySettings : Object
{
    private QualitySettings()
    {
    }

    public static float lodBias { get; set; } = 1f;
}
