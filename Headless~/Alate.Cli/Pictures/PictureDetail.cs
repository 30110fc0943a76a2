using System;

namespace Alate.Cli.Pictures;

/// <summary>
/// Fineness with which insects are painted: a finer picture looks smoother and makes a larger file. All numbers are chosen by eye.
/// </summary>
/// <param name="LeastParted">Area on the picture below which a triangle of the mesh is painted as a whole.</param>
/// <param name="LeastTriangles">Triangles that a wing is parted into at least.</param>
/// <param name="Softness">Width over which a pattern's colours blend, over the edge of a painted triangle.</param>
/// <param name="PatternStep">Steps of a pattern's colour, sRGB: neighbours that differ by less are painted in one go.</param>
/// <param name="VertexStep">The same for vertex colours, which pass into one another: coarse steps change their hue in bands.</param>
/// <param name="LightStep">Steps of light.</param>
/// <param name="RimStep">Steps of the rim's light and of gloss.</param>
/// <param name="ColourStep">Steps of the shown colour, of 255.</param>
/// <param name="GlassStep">Steps of how much is seen through a surface, of 100.</param>
/// <param name="WingColours">Colours of a wing, over the one that most of it has; 0 for as many as there are.</param>
/// <param name="BodyColours">The same for the body.</param>
/// <param name="Alike">Colours that differ by less, sRGB and opacity, are painted like the more frequent one.</param>
/// <param name="Fineness">Steps of a path in a unit of the picture.</param>
/// <param name="Slack">How far, in such steps, a path may stray.</param>
/// <param name="TestFineness">Points in a unit of length at which pieces are tested for lying over one another.</param>
internal sealed record PictureDetail(
    float LeastParted, int LeastTriangles, float Softness, float PatternStep, float VertexStep, float LightStep, float RimStep, int ColourStep,
    int GlassStep, int WingColours, int BodyColours, float Alike, float Fineness, float Slack, float TestFineness)
{
    /// <summary>For large pictures: about 100 kB a pose.</summary>
    public static readonly PictureDetail Fine = new(1.6f, 6000, 0.5f, 0.05f, 0.012f, 0.05f, 0.03f, 5, 10, 0, 0, 0f, 5f, 0.8f, 1.5f);

    /// <summary>For a few poses of middle size: about 40 kB a pose.</summary>
    public static readonly PictureDetail Medium = new(5f, 0, 0.5f, 0.02f, 0.02f, 0.15f, 1f, 5, 25, 5, 3, 0.12f, 2.5f, 1.6f, 1.5f);

    /// <summary>For pictures of many small poses: about 10 kB a pose.</summary>
    public static readonly PictureDetail Small = new(6f, 0, 1f, 0.02f, 0.02f, 0.24f, 1f, 5, 25, 3, 1, 0.3f, 2f, 2f, 1f);

    /// <summary>The rules that painted paths need in the picture's style.</summary>
    public string Style => FormattableString.Invariant(
        $".f{{fill:currentColor;stroke:currentColor;stroke-width:{0.4f * Fineness};stroke-linejoin:round}}")
        + FormattableString.Invariant($".l{{fill:none;stroke:currentColor;stroke-width:{0.7f * Fineness};stroke-linejoin:round;stroke-linecap:round}}");
}
