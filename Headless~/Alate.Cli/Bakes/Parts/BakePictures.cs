using Alate.Crowds;

namespace Alate.Cli;

/// <summary>Pictures on the wings of a baked insect.</summary>
internal sealed class BakePictures
{
    /// <summary>Name of a wing of the user's own, before its side.</summary>
    public const string OwnWing = "wing";

    private readonly Dictionary<string, Lazy<WingTexture>> m_Of = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>The paintings of the catalogue, or the pictures of an insect file.</summary>
    public BakePictures(InsectDefinition insect)
    {
        foreach (WingDefinition wing in insect.Wings)
            Add(wing.Name, () => wing.Picture == null ? WingPainting.Of(wing) : WingTexture.Of(wing.Picture));
    }

    /// <summary>The picture of a wing of the user's own.</summary>
    public BakePictures(WingFiles wing)
    {
        if (wing.Picture != null)
            Add(OwnWing, () => WingTexture.Of(wing.Picture));
    }

    /// <summary>The picture for the texture coordinates of a part; null for none.</summary>
    public WingTexture Of(BakedPart part) => m_Of.TryGetValue(part.Name, out Lazy<WingTexture> picture) ? picture.Value : null;

    /// <summary>True where the colours of a part's vertices let some of it be seen through.</summary>
    public static bool IsGlass(InsectBake bake, BakedPart part) =>
        part.HasColours && part.Triangles.Any(vertex => bake.Surface.Colours[vertex].a < byte.MaxValue);

    // A part has the name of its first renderer, which says the side.
    private void Add(string wing, Func<WingTexture> make)
    {
        var picture = new Lazy<WingTexture>(make);
        foreach (WingSide side in Enum.GetValues<WingSide>())
            m_Of[$"{wing} {side}"] = picture;
    }
}
