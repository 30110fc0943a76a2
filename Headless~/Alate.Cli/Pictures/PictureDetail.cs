namespace Alate.Cli.Pictures;

/// <summary>How finely insects are painted: what is finer looks smoother and makes a larger file. All numbers are chosen by eye.</summary>
/// <param name="LeastParted">Area on the picture below which a triangle of the mesh is painted as a whole.</param>
/// <param name="LeastTriangles">Triangles that a wing is parted into at least.</param>
/// <param name="PatternStep">Steps of a pattern's colour, sRGB: neighbours that differ by less are painted in one go.</param>
/// <param name="VertexStep">The same for vertex colours, which pass into one another: coarse steps change their hue in bands.</param>
/// <param name="LightStep">Steps of light.</param>
/// <param name="RimStep">Steps of the rim's light and of gloss.</param>
/// <param name="ColourStep">Steps of the shown colour, of 255.</param>
/// <param name="TestFineness">Points in a unit of length at which pieces are tested for lying over one another.</param>
internal sealed record PictureDetail(
    float LeastParted, int LeastTriangles, float PatternStep, float VertexStep, float LightStep, float RimStep, int ColourStep, float TestFineness)
{
    /// <summary>For large pictures: about 300 kB a pose.</summary>
    public static readonly PictureDetail Fine = new(1.6f, 6000, 0.05f, 0.012f, 0.05f, 0.03f, 5, 1.5f);

    /// <summary>For pictures of many small poses: about 10 kB a pose.</summary>
    public static readonly PictureDetail Small = new(4f, 0, 0.2f, 0.1f, 0.12f, 0.16f, 15, 1.5f);
}
