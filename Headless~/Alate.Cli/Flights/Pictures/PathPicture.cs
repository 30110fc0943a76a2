using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// path.png: a flight from above and from the side, with the insect drawn along it, larger than the way by a factor that the reader is
/// told.
/// </summary>
internal static class PathPicture
{
    private const int k_Width = 1400, k_Height = 700, k_Insects = 9;
    private const float k_Inset = 0.1f, k_Size = 0.16f, k_Softness = 0.02f, k_Dot = 1.2f;

    /// <summary>The picture as a PNG file.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="factor">How many times larger than the way the insects are drawn.</param>
    public static byte[] Draw(FreeRecord flight, out float factor)
    {
        float3 way = flight.Moments[^1].Position - flight.Moments[0].Position;
        float aside = math.length(way.xz) < 0.1f ? -90f : math.degrees(math.atan2(-way.z, -way.x));
        PictureView[] views = [new("above", 180f, 90f), new("the side", aside, 0f)];
        float extent = Extent(flight);
        factor = k_Size * extent / FlightPhoto.Reach(flight.Beat);
        var picture = new Texture2D(k_Width, 2 * k_Height);
        for (int k = 0; k < views.Length; k++)
        {
            Color32[] pixels = Panel(flight, views[k], extent, factor);
            for (int pixel = 0; pixel < pixels.Length; pixel++)
                picture.SetPixel(pixel % k_Width, picture.height - 1 - k * k_Height - pixel / k_Width, pixels[pixel]);
        }

        byte[] png = picture.EncodeToPNG();
        UnityEngine.Object.DestroyImmediate(picture);
        return png;
    }

    private static Color32[] Panel(FreeRecord flight, PictureView view, float extent, float factor)
    {
        var camera = new PictureCamera(view, 1000f * extent);
        var trail = flight.Moments.Select(at => camera.Project(at.Position)).ToList();
        float2 min = trail.Aggregate(new float2(float.PositiveInfinity), (least, place) => math.min(least, place.xy));
        float2 max = trail.Aggregate(new float2(float.NegativeInfinity), (most, place) => math.max(most, place.xy));
        float2 span = math.max(max - min, 0.3f * extent);
        float scale = math.cmin(new float2(k_Width, k_Height) * (1f - 2f * k_Inset) / (span + 2f * k_Size * extent));
        float2 shift = 0.5f * new float2(k_Width, k_Height) - scale * 0.5f * (min + max);
        var grid = new SampleGrid(k_Width, k_Height);
        var shading = new Shading(camera);
        foreach (float3 place in trail)
        {
            grid.AddDisc(
                SampleGrid.k_Fineness * (scale * place.xy + shift), k_Dot * SampleGrid.k_Fineness, place.z + extent, PhotoScene.TrailLight);
        }
        for (int k = 0; k < k_Insects; k++)
            Insect(grid, shading, camera, flight, flight.Moments[(flight.Moments.Count - 1) * k / (k_Insects - 1)], factor, scale, shift);
        Color32[] pixels = grid.Pixels(Shading.ToLinear(Shading.Paper));
        var labels = new PathLabels(pixels, k_Width);
        labels.Title(FormattableString.Invariant(
            $"from {view.Words}, {flight.Moments[^1].Time:0.#} s, the insect drawn {factor:0.#} times as large as the way"));
        labels.Scale(scale);
        return pixels;
    }

    private static void Insect(
        SampleGrid grid, Shading shading, PictureCamera camera, FreeRecord flight, FreeMoment at, float factor, float scale, float2 shift)
    {
        float3 Seen(float3 body)
        {
            float3 place = camera.Project(at.Position + math.rotate(at.Rotation, factor * (body - flight.Centre)));
            return new float3(SampleGrid.k_Fineness * (scale * place.xy + shift), place.z);
        }

        float3 Turned(float3 normal) => math.rotate(at.Rotation, normal);
        SurfaceMesh body = flight.Beat.Insect.Body;
        PhotoSurface.Of(body).Draw(
            grid, Array.ConvertAll(body.positions, place => Seen(place)),
            Array.ConvertAll(body.normals, normal => Turned(normal)), shading, 1f);
        int index = 1;
        foreach (RecordedWing wing in flight.Beat.Wings)
        {
            (float3[] positions, float3[] normals) = wing.At(at.Phase / (2.0 * Math.PI));
            FlightPhoto.Surface(index++, wing)
                .Draw(grid, Array.ConvertAll(positions, Seen), Array.ConvertAll(normals, Turned), shading, k_Softness);
        }
    }

    private static float Extent(FreeRecord flight)
    {
        float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
        foreach (FreeMoment at in flight.Moments)
        {
            min = math.min(min, at.Position);
            max = math.max(max, at.Position);
        }

        return math.max(math.cmax(max - min), 0.05f);
    }
}
