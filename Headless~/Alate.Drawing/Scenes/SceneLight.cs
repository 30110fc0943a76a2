namespace Alate.Drawing;

/// <summary>Light of a scene, and the answer of surfaces to it, as the shader <c>Alate/Wing</c> has them in linear colour space.</summary>
/// <param name="Sky">Linear light from above.</param>
/// <param name="Equator">Linear light from the sides.</param>
/// <param name="Ground">Linear light from below.</param>
/// <param name="SunFrom">Direction towards the sun, unit length.</param>
/// <param name="Sun">Linear light of the sun; 0 where there is none.</param>
/// <param name="HasShadows">True where things stand in the way of the sun.</param>
/// <param name="Lamps">Other lights.</param>
internal sealed record SceneLight(
    float3 Sky, float3 Equator, float3 Ground, float3 SunFrom, float3 Sun, bool HasShadows, IReadOnlyList<SceneLamp> Lamps)
{
    /// <summary>Square of the distance below which a lamp grows no brighter, units of the scene.</summary>
    private const float k_Nearest = 1e-3f;

    /// <summary>True where a sun shines.</summary>
    public bool HasSun => math.any(Sun > 0f);

    /// <summary>Light of a surface towards the eye, linear.</summary>
    /// <param name="look">Its material.</param>
    /// <param name="colour">Its linear light, 0 to 1.</param>
    /// <param name="place">Units of the scene.</param>
    /// <param name="normal">Unit vector; a wing's on its upper side.</param>
    /// <param name="toEye">Unit vector.</param>
    /// <param name="sunShare">Share of the sun's light that reaches it, 0 to 1.</param>
    public float3 Of(SceneLook look, float3 colour, float3 place, float3 normal, float3 toEye, float sunShare)
    {
        if (look.IsTwoSided && math.dot(normal, toEye) < 0f)
            (normal, colour) = (-normal, Shading.Below(colour, look.Underside));
        float3 sum = colour * math.lerp(Ambient(normal), Ambient(-normal), 0.5f * look.Through);
        if (HasSun)
            sum += sunShare * Sun * Answer(look, colour, normal, toEye, SunFrom);
        foreach (SceneLamp lamp in Lamps)
        {
            float3 way = lamp.Place - place;
            float square = math.max(math.lengthsq(way), k_Nearest), share = square / (lamp.Range * lamp.Range);
            if (share >= 1f)
                continue;
            float end = (1f - share * share) * (1f - share * share);
            sum += end / square * lamp.Light * Answer(look, colour, normal, toEye, math.normalizesafe(way));
        }

        return sum;
    }

    private float3 Ambient(float3 normal) => normal.y > 0f ? math.lerp(Equator, Sky, normal.y) : math.lerp(Equator, Ground, -normal.y);

    // What falls on the side that is seen; what passes from the other one, filtered twice by the colour; and a gleam.
    private static float3 Answer(SceneLook look, float3 colour, float3 normal, float3 toEye, float3 toLight)
    {
        float facing = math.dot(normal, toLight);
        float3 diffuse = colour * math.saturate(facing);
        float3 passed = colour * (0.35f + 0.65f * colour) * (look.Through * math.saturate(-facing));
        float half = math.saturate(math.dot(normal, math.normalizesafe(toLight + toEye)));
        return diffuse + passed + look.Gloss * math.pow(half, look.Shine) * math.saturate(8f * facing);
    }
}
