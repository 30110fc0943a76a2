namespace Alate.Drawing;

/// <summary>Light from one direction, and what surfaces leave of it.</summary>
internal sealed class ShadowMap
{
    /// <summary>Cells over which the edge of a shadow is blurred.</summary>
    private const float k_Blur = 3f;

    private readonly float3 m_Across, m_Along, m_Towards;
    private readonly float m_Cell, m_Fade;
    private readonly ShadowLayer[] m_Layers;

    /// <param name="casters">What stands in the way; null for what does not.</param>
    /// <param name="towards">Where the light comes from, unit length.</param>
    /// <param name="softness">Metres over which the edge of a shadow is blurred; it is also the depth in which a shadow begins.</param>
    /// <param name="finest">Metres of the smallest cell that is worth it.</param>
    public ShadowMap(IReadOnlyList<ShadowCaster> casters, float3 towards, float softness, float finest)
    {
        m_Towards = towards;
        m_Across = math.normalize(math.cross(towards, math.abs(towards.z) < 0.9f ? new float3(0f, 0f, 1f) : new float3(1f, 0f, 0f)));
        m_Along = math.cross(towards, m_Across);
        m_Cell = math.max(softness / k_Blur, finest);
        m_Fade = softness;
        int blur = math.max((int)math.round(softness / m_Cell), 1);
        m_Layers = [.. casters.Select(caster => caster == null ? null : new ShadowLayer(
            Array.ConvertAll(caster.Places, PlaceOf), Array.ConvertAll(caster.Places, HeightOf), caster, blur))];
    }

    /// <summary>Share of the light that reaches a place of a surface, 0 to 1; no surface takes it away from itself.</summary>
    /// <param name="own">Number of the surface among the casters.</param>
    /// <param name="place">Metres.</param>
    public float At(int own, float3 place)
    {
        float left = 1f, height = HeightOf(place);
        float2 seen = PlaceOf(place);
        for (int k = 0; k < m_Layers.Length; k++)
        {
            if (k != own && m_Layers[k] != null)
                left *= 1f - m_Layers[k].At(seen, height, m_Fade);
        }

        return left;
    }

    private float2 PlaceOf(float3 place) => new float2(math.dot(place, m_Across), math.dot(place, m_Along)) / m_Cell;

    private float HeightOf(float3 place) => math.dot(place, m_Towards);
}
