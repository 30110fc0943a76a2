namespace Unity.StandIns;

/// <summary>Lets a test run on a device that draws no instances and reads vertices of floats only.</summary>
[StandInExtension]
public static class PlainDevice
{
    /// <summary>True where the device is plain.</summary>
    public static bool IsInUse { get; set; }
}
