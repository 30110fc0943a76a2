namespace Alate.Cli;

/// <summary>Colours of vortex rings: red and blue for the two ways in which they turn, the denser the stronger.</summary>
internal static class WakeColours
{
    private const float k_Faintest = 0.05f, k_Densest = 0.7f;

    private static readonly float3 s_Positive = Shading.Colour(0xb3261e), s_Negative = Shading.Colour(0x1f5fa8);

    /// <summary>The strongest circulation of sheets, m²/s.</summary>
    public static float Strongest(IEnumerable<ShapedSheet> sheets) =>
        math.max(sheets.SelectMany(sheet => sheet.Circulation).Select(math.abs).DefaultIfEmpty().Max(), 1e-12f);

    /// <summary>Bytes of the sRGB colour of a share.</summary>
    public static int3 Bytes(float share) => (int3)math.round(255f * Of(share).xyz);

    /// <summary>sRGB colour and opacity of a circulation, as a share of the strongest, −1 to 1.</summary>
    public static float4 Of(float share) =>
        new(share < 0f ? s_Negative : s_Positive, math.lerp(k_Faintest, k_Densest, math.saturate(math.abs(share))));
}
