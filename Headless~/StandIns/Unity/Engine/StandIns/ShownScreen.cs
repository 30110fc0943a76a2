namespace Unity.StandIns;

/// <summary>The screen of a test.</summary>
[StandInExtension]
public static class ShownScreen
{
    /// <summary>Screen.dpi; 0 where a system does not tell it.</summary>
    public static float Dpi { get; set; } = 96f;
}
