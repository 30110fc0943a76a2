using Alate.Crowds;

namespace Alate.Cli;

/// <summary>Looks of a baked insect in photos.</summary>
internal static class BakePhoto
{
    /// <summary>Scene of an insect that sits with its wings folded.</summary>
    /// <param name="insect">The insect.</param>
    public static PhotoScene AtRest(InsectDefinition insect)
    {
        InsectWings live = InsectFactory.Create(insect, InsectVariant.Standard);
        try
        {
            InsectBake bake = InsectBaker.Bake(live, [BakeMotion.Find("folded")], new BakeSettings(4));
            return Scene(bake, insect, new PictureView("", 62f, 16f));
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(live.gameObject);
        }
    }

    // Of the first frame.
    private static PhotoScene Scene(InsectBake bake, InsectDefinition insect, PictureView view)
    {
        BakedFrame frame = bake.Clips[0].Frames[0];
        float3[] places = Array.ConvertAll(frame.Positions, place => bake.MetresPerUnit * place);
        var pictures = new BakePictures(insect);
        return new PhotoScene(view, places.Max(place => math.length(place)), [.. bake.Surface.Parts
            .Select((part, k) => new PhotoPart(Surface(bake.Surface, part, k, insect, pictures), bake.MetresPerUnit * bake.WingLength,
                _ => (places, frame.Normals)))]);
    }

    private static PhotoSurface Surface(BakedSurface bake, BakedPart part, int index, InsectDefinition insect, BakePictures pictures)
    {
        WingDefinition wing = insect.Wings.FirstOrDefault(
            kind => part.Name.StartsWith(kind.Name, StringComparison.OrdinalIgnoreCase));
        if (wing == null)
            return PhotoSurface.Of(new SurfaceMesh { positions = bake.Positions, colours = bake.Colours, triangles = part.Triangles });
        float3[] rest = Array.ConvertAll(bake.Positions, place => (float3)place);
        if (wing.Pattern != null && wing.Picture == null)
        {
            (double rear, double depth) = (wing.Contour.Rear, wing.Contour.Front - wing.Contour.Rear);
            return FlightPhoto.Painted(index, rest, part.Triangles,
                Array.ConvertAll(bake.Uvs, uv => new float4(uv.x, 0f, (float)(rear + uv.y * depth), 0f)), wing);
        }

        return pictures.Of(part) is { } picture
            ? PhotoSurface.Thin(index, rest, part.Triangles, Array.ConvertAll(bake.Uvs, uv => new float4(uv, 0f, 0f)),
                (uv, _) => picture.ColourAt(uv.xy), true)
            : PhotoSurface.Thin(index, rest, part.Triangles, Array.ConvertAll(bake.Colours, colour => Shading.Linear(colour)),
                (colour, _) => colour);
    }
}
