namespace Alate.Drawing;

/// <summary>Surface that stands in the way of light.</summary>
/// <param name="Places">[vertex] Metres, in the axes of the lights.</param>
/// <param name="Triangles">Three vertex indices a triangle.</param>
/// <param name="Taken">[vertex] Share of the light that it takes away, 0 to 1.</param>
internal sealed record ShadowCaster(float3[] Places, int[] Triangles, float[] Taken);
