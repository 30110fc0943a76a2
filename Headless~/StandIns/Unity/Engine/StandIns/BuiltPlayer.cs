namespace Unity.StandIns;

/// <summary>Lets a test run as in a player, not as in the editor.</summary>
[StandInExtension]
public static class BuiltPlayer
{
    /// <summary>True where Application.isEditor is false.</summary>
    public static bool IsRunning { get; set; }
}
