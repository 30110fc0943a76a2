using UnityEngine;

namespace Alate.Drawing;

/// <summary>
/// The light of the pictures: a key light from the viewer's upper left, a bright sky, wings that let light through, bodies that
/// shine a little, and a rim where a surface turns away.
/// All numbers are chosen by eye.
/// </summary>
internal sealed class Shading
{
    /// <summary>Share of the light that passes a wing.</summary>
    public const float Through = 0.42f;

    private const float k_Ambient = 0.42f, k_Key = 0.68f, k_Rim = 0.16f, k_RimPower = 3f, k_Sky = 0.16f;
    private const float k_Gloss = 0.1f, k_GlossPower = 24f;

    /// <summary>The paper of all pictures, sRGB.</summary>
    public static readonly float3 Paper = Colour(0xf7f4ec);

    private static readonly float3 s_ThroughTint = new(1.1f, 0.98f, 0.82f);
    private readonly float3 m_Towards, m_Half;

    /// <param name="camera">Who looks.</param>
    public Shading(PictureCamera camera)
    {
        m_Towards = camera.Towards;
        Key = camera.Direction(-0.45f, 0.8f, 0.55f);
        m_Half = math.normalize(Key + m_Towards);
    }

    /// <summary>Direction towards the key light, unit length.</summary>
    public float3 Key { get; }

    /// <summary>Light of a surface, linear.</summary>
    /// <param name="colour">Linear light, 0 to 1.</param>
    /// <param name="normal">Unit vector on the body: a wing's upper side; of others which side it points to does not matter.</param>
    /// <param name="isThin">A wing, which light passes; else a body.</param>
    /// <param name="keyShare">Share of the key light that reaches it, 0 to 1.</param>
    /// <param name="skyShare">Share of the light from all around that reaches it, 0 to 1.</param>
    /// <param name="underside">Linear light towards which the lower side of a wing is paler, and how far.</param>
    public float3 Light(
        float3 colour, float3 normal, bool isThin, float keyShare = 1f, float skyShare = 1f, float4 underside = default)
    {
        float facing = math.dot(normal, m_Towards);
        colour = isThin && facing < 0f ? Below(colour, underside) : colour;
        normal = facing < 0f ? -normal : normal;
        float key = math.dot(normal, Key);
        float through = isThin ? keyShare * Through * math.max(-key, 0f) : 0f;
        float rim = k_Rim * math.pow(1f - math.min(math.abs(facing), 1f), k_RimPower);
        float gloss = isThin ? 0f : keyShare * k_Gloss * math.pow(math.max(math.dot(normal, m_Half), 0f), k_GlossPower);
        float light = skyShare * (k_Ambient + k_Sky * normal.y) + keyShare * k_Key * math.max(key, 0f);
        return colour * (light + through * s_ThroughTint) + rim * (0.4f * colour + 0.25f) + gloss;
    }

    /// <summary>Linear light of the lower side of a wing: paler by a colour where it is bright.</summary>
    /// <param name="colour">Linear light of the upper side, 0 to 1.</param>
    /// <param name="underside">Linear light of that colour, and how far it goes, 0 to 1.</param>
    public static float3 Below(float3 colour, float4 underside) =>
        math.lerp(colour, underside.xyz, underside.w * math.saturate(math.cmax(colour)));

    /// <summary>Linear light of a colour, and its opacity.</summary>
    public static float4 Linear(Color colour) => new(ToLinear(new float3(colour.r, colour.g, colour.b)), colour.a);

    /// <summary>Light of an sRGB value.</summary>
    public static float3 ToLinear(float3 encoded) => math.pow(encoded, 2.2f);

    /// <summary>An sRGB colour from 0 to 1.</summary>
    public static float3 Colour(int rgb) => new float3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255f;

    /// <summary>The opaque pixel of an sRGB colour.</summary>
    public static Color32 Bytes(float3 encoded)
    {
        var shown = (int3)math.round(255f * encoded);
        return new Color32((byte)shown.x, (byte)shown.y, (byte)shown.z, byte.MaxValue);
    }

    /// <summary>The sRGB value of a light.</summary>
    public static float3 ToEncoded(float3 linear) => math.pow(math.saturate(linear), 1f / 2.2f);
}
