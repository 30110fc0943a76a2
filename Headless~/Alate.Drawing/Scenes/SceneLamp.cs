namespace Alate.Drawing;

/// <summary>Lamp that shines to all sides.</summary>
/// <param name="Place">Units of the scene.</param>
/// <param name="Light">Linear light at a distance of one unit.</param>
/// <param name="Range">Distance at which it ends, units of the scene.</param>
internal readonly record struct SceneLamp(float3 Place, float3 Light, float Range);
