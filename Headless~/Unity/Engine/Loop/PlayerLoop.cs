namespace Unity.StandIns;

/// <summary>Unity's frame, driven by hand.</summary>
[StandInExtension]
public static partial class PlayerLoop
{
    /// <summary>What Application.isPlaying says.</summary>
    public static bool IsPlaying { get; private set; }
}
