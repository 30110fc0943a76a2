namespace Unity.StandIns;

/// <summary>Lets a test run on a device that draws no instances.</summary>
[StandInExtension]
public static class PlainDevice
{
    /// <summary>Whether SystemInfo.supportsInstancing is false.</summary>
    public static bool IsInUse { get; set; }
}
