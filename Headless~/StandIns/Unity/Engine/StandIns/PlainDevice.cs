namespace Unity.StandIns;

/// <summary>Lets a test run on a device that draws no instances, reads vertices of floats only and no textures of floats.</summary>
[StandInExtension]
public static class PlainDevice
{
    /// <summary>True where the device is plain.</summary>
    public static bool IsInUse { get; set; }

    /// <summary>Largest side of a texture, pixels.</summary>
    public static int LargestTexture { get; set; } = 16384;
}
