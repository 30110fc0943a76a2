using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>A device that can do what a desktop computer's can.</summary>
public sealed class SystemInfo
{
    public static GraphicsDeviceType graphicsDeviceType => GraphicsDeviceType.Null;
    public static string graphicsDeviceName => "no graphics device";
    public static string operatingSystem => System.Runtime.InteropServices.RuntimeInformation.OSDescription;
    public static string processorType => System.Runtime.InteropServices.RuntimeInformation.ProcessArchitecture.ToString();
    public static int maxConstantBufferSize => 65536;
    public static int maxTextureSize => Unity.StandIns.PlainDevice.LargestTexture;
    public static bool supportsInstancing => !Unity.StandIns.PlainDevice.IsInUse;

    public static bool SupportsTextureFormat(TextureFormat format) =>
        !Unity.StandIns.PlainDevice.IsInUse || format is TextureFormat.RGBA32 or TextureFormat.ARGB32 or TextureFormat.RGB24;

    public static bool SupportsVertexAttributeFormat(VertexAttributeFormat format, int dimension) =>
        !Unity.StandIns.PlainDevice.IsInUse || format == VertexAttributeFormat.Float32;
}
