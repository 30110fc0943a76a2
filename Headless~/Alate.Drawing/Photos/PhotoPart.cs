namespace Alate.Drawing;

/// <summary>Body or wing of an insect as photos show it.</summary>
/// <param name="Surface">Its looks.</param>
/// <param name="Length">Metres of the length in which widths of its pattern are counted.</param>
/// <param name="At">[vertex] Places on the body, metres, and normals at a phase, 0 to 1 beats.</param>
/// <param name="Rest">[vertex] Places as it is made, metres; null for what does not move.</param>
internal sealed record PhotoPart(
    PhotoSurface Surface, float Length, Func<double, (float3[] Places, float3[] Normals)> At, float3[] Rest = null);
