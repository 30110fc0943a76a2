namespace Alate.Drawing;

/// <summary>A rectangle of the strip that shows one phase.</summary>
/// <param name="Left">Of the strip.</param>
/// <param name="Top">Of the strip.</param>
/// <param name="Width">Units of the picture.</param>
/// <param name="Height">Units of the picture.</param>
/// <param name="Scale">Units of the picture for a metre of the camera's plane.</param>
/// <param name="Centre">What of the camera's plane lies in the middle.</param>
internal readonly record struct StripPanel(float Left, float Top, float Width, float Height, float Scale, float2 Centre)
{
    /// <summary>A panel of a size that a pose fills but for a distance from the edges.</summary>
    public static StripPanel Around(Pose pose, float2 size, float inset)
    {
        (float2 min, float2 max) = pose.Bounds();
        return new StripPanel(0f, 0f, size.x, size.y, math.cmin((size - 2f * inset) / (max - min)), 0.5f * (min + max));
    }

    /// <summary>The place of the camera's plane that lies at a place of the panel.</summary>
    public float2 SeenAt(float2 place) => (place - 0.5f * new float2(Width, Height)) / Scale + Centre;

    /// <summary>A place that the camera sees, in the panel.</summary>
    public float3 Place(float3 seen) => new((seen.xy - Centre) * Scale + 0.5f * new float2(Width, Height), seen.z);
}
