using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>A rectangle of the strip that shows one phase.</summary>
/// <param name="Left">Of the strip.</param>
/// <param name="Top">Of the strip.</param>
/// <param name="Width">Units of the picture.</param>
/// <param name="Height">Units of the picture.</param>
/// <param name="Scale">Units of the picture for a metre of the camera's plane.</param>
/// <param name="Centre">What of the camera's plane lies in the middle.</param>
internal readonly record struct StripPanel(float Left, float Top, float Width, float Height, float Scale, float2 Centre)
{
    /// <summary>A place that the camera sees, in the panel.</summary>
    public float3 Place(float3 seen) => new((seen.xy - Centre) * Scale + 0.5f * new float2(Width, Height), seen.z);
}
