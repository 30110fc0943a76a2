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
            return Scene(bake, new BakePictures(insect), new PictureView("", 62f, 16f));
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(live.gameObject);
        }
    }

    /// <summary>Scene of the first frame of a bake.</summary>
    /// <param name="bake">The bake.</param>
    /// <param name="pictures">Pictures on its wings.</param>
    /// <param name="view">From where it is seen.</param>
    private static PhotoScene Scene(InsectBake bake, BakePictures pictures, PictureView view)
    {
        BakedFrame frame = bake.Clips[0].Frames[0];
        float3[] places = Array.ConvertAll(frame.Positions, place => bake.MetresPerUnit * place);
        float reach = places.Max(place => math.length(place));
        return new PhotoScene(view, reach, [.. bake.Surface.Parts
            .Select((part, k) => new PhotoPart(Surface(bake, pictures, part, k), bake.MetresPerUnit * bake.WingLength,
                _ => (places, frame.Normals)))]);
    }

    private static PhotoSurface Surface(InsectBake bake, BakePictures pictures, BakedPart part, int index)
    {
        float3[] rest = Array.ConvertAll(bake.Surface.Positions, place => (float3)place);
        float4[] colours = bake.Surface.Colours == null ? null : Array.ConvertAll(bake.Surface.Colours, colour => Shading.Linear(colour));
        if (pictures.Of(part) is not { } picture)
            return PhotoSurface.Thin(index, rest, part.Triangles, colours, (colour, _) => colour, hasEdge: false);
        return PhotoSurface.Thin(
            index, rest, part.Triangles, Array.ConvertAll(bake.Surface.Uvs, uv => new float4(uv, 0f, 0f)),
            (uv, _) => picture.ColourAt(uv.xy), true,
            isWithin: picture.Opacity == PictureOpacity.Cut ? uv => picture.ColourAt(uv.xy).w >= 0.5f : null);
    }
}
