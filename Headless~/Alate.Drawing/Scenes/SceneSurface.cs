namespace Alate.Drawing;

/// <summary>Surface of a scene at one moment.</summary>
/// <param name="Places">[vertex] Units of the scene.</param>
/// <param name="Normals">[vertex] Unit vectors.</param>
/// <param name="Triangles">Three vertex indices a triangle.</param>
/// <param name="Coordinates">[vertex] Where in the picture; null where it has none.</param>
/// <param name="Colours">[vertex] Linear light and opacity; null for white.</param>
/// <param name="Look">Its material.</param>
internal sealed record SceneSurface(
    float3[] Places, float3[] Normals, int[] Triangles, float2[] Coordinates, float4[] Colours, SceneLook Look)
{
    /// <summary>True where it stands in the way of the sun.</summary>
    public bool CastsShadow { get; init; } = true;
}
