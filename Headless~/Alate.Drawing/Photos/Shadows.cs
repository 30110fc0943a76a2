namespace Alate.Drawing;

/// <summary>
/// Shadows that the surfaces of an insect cast on one another: of the key light, and of the sky, which is dim below a wing.
/// All numbers are chosen by eye.
/// </summary>
internal sealed class Shadows
{
    /// <summary>Blur of the key light's shadows and of the sky's, over the reach of the insect.</summary>
    private const float k_Sharp = 0.02f, k_Dim = 0.1f;

    /// <summary>Share of the light from all around that comes from above.</summary>
    private const float k_FromAbove = 0.5f;

    private readonly ShadowMap m_Key, m_Sky;

    /// <param name="casters">What stands in the way of light; null for what does not.</param>
    /// <param name="key">Where the key light comes from, unit length.</param>
    /// <param name="reach">Farthest that any surface comes from the middle, metres.</param>
    /// <param name="finest">Metres of the finest part of a shadow that is worth it.</param>
    public Shadows(ShadowCaster[] casters, float3 key, float reach, float finest)
    {
        m_Key = new ShadowMap(casters, key, k_Sharp * reach, finest);
        m_Sky = new ShadowMap(casters, new float3(0f, 1f, 0f), k_Dim * reach, finest);
    }

    /// <summary>Share of the key light that reaches a place of a surface, 0 to 1.</summary>
    /// <param name="own">Number of the surface among the casters.</param>
    /// <param name="place">Metres.</param>
    public float Key(int own, float3 place) => m_Key.At(own, place);

    /// <summary>Share of the light from all around that reaches a place of a surface, 0 to 1; it changes slowly.</summary>
    /// <inheritdoc cref="Key"/>
    public float Sky(int own, float3 place) => 1f - k_FromAbove * (1f - m_Sky.At(own, place));
}
