namespace Alate.Drawing;

/// <summary>Material of a surface of a scene, with the properties of the shader <c>Alate/Wing</c>.</summary>
/// <param name="Picture">Its texture; null for white.</param>
/// <param name="Tint">Linear light and opacity by which all is multiplied.</param>
/// <param name="ShowsColours">True where the colours of the vertices count.</param>
/// <param name="IsTwoSided">True for a wing, which has no inside.</param>
/// <param name="IsTranslucent">True where the opacity counts.</param>
/// <param name="Through">Share of the light that passes it, 0 to 1.</param>
/// <param name="Gloss">Strength of its gleam, 0 to 1.</param>
/// <param name="Shine">Narrowness of its gleam.</param>
internal sealed record SceneLook(
    MippedPicture Picture, float4 Tint, bool ShowsColours, bool IsTwoSided, bool IsTranslucent, float Through, float Gloss, float Shine)
{
    /// <summary>True where the opacity of the picture is the outline of what is drawn.</summary>
    public bool IsCut { get; init; }

    /// <summary>Linear light towards which the lower side is paler, and how far.</summary>
    public float4 Underside { get; init; }
}
