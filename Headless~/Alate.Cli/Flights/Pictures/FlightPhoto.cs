namespace Alate.Cli;

/// <summary>Looks of flown insects and their wings in photos.</summary>
internal static class FlightPhoto
{
    /// <summary>Scene of an insect that was flown.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="view">From where it is seen; null is from where its plan says.</param>
    /// <param name="surfaceOf">Looks of the wings, by their numbers, without shadows; null for their own.</param>
    public static PhotoScene Scene(FlightRecord flight, PictureView? view = null, Func<int, RecordedWing, PhotoSurface> surfaceOf = null)
    {
        var body = new PhotoPart(PhotoSurface.Of(flight.Insect.Body), 1f, Body(flight));
        return new PhotoScene(view ?? flight.Plan.View, Reach(flight),
            [body, .. flight.Wings.Select((wing, k) => Part(wing, (surfaceOf ?? Surface)(k + 1, wing)))], surfaceOf == null);
    }

    private static Func<double, (float3[], float3[])> Body(FlightRecord flight)
    {
        if (flight.Insect.Abdomen is { } abdomen)
            return turns => abdomen.Pose(flight.AbdomenAt(turns));
        float3[] places = Array.ConvertAll(flight.Insect.Body.positions, place => (float3)place);
        float3[] normals = Array.ConvertAll(flight.Insect.Body.normals, normal => (float3)normal);
        return _ => (places, normals);
    }

    /// <summary>Farthest that a wing comes from the middle of the thorax, metres.</summary>
    public static float Reach(FlightRecord flight) => flight.Wings.Max(wing => math.length(wing.Placement.Hinge) + wing.Placement.Length);

    /// <summary>A wing in its pattern, its picture or the colours of its vertices, or pale where it has none.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="wing">The wing.</param>
    public static PhotoSurface Surface(int index, RecordedWing wing)
    {
        InsectWing own = wing.Wing;
        if (own.Pattern != null)
        {
            return Painted(index, wing.Rest, wing.Triangles,
                Array.ConvertAll(own.Surface.positions, place => new float4(place, 0f) / own.PatternScale), own.Definition);
        }
        if (own.Surface.uvs != null && own.Texture is WingTexture picture)
            return Thin(Array.ConvertAll(own.Surface.uvs, uv => new float4(uv, 0f, 0f)), (place, _) => picture.ColourAt(place.xy), true);
        return own.Colours != null
            ? Thin(Array.ConvertAll(own.Colours, colour => Shading.Linear(colour)), (colour, _) => colour)
            : Thin(new float4[wing.Rest.Length], null);

        PhotoSurface Thin(float4[] values, Func<float4, float, float4> colourOf, bool hasPattern = false) =>
            PhotoSurface.Thin(index, wing.Rest, wing.Triangles, values, colourOf, hasPattern);
    }

    /// <summary>A wing in the pattern of the catalogue.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="rest">[vertex] Its places at rest.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="places">[vertex] Places on the pattern, wing lengths: x along the span, z ahead.</param>
    /// <param name="wing">The wing.</param>
    public static PhotoSurface Painted(int index, float3[] rest, int[] triangles, float4[] places, WingDefinition wing)
    {
        (WingPattern pattern, MarginCut margin) = (wing.Pattern, wing.Margin);
        return PhotoSurface.Thin(
            index, rest, triangles, places, (place, softness) => Shading.Linear(pattern.ColourAt(place.x, place.z, softness)), true,
            underside: Shading.Linear(pattern.Underside), isWithin: place => margin.Contains(place.x, place.z));
    }

    /// <summary>A scene with lines around the wings of another flight of the same insect, before all else.</summary>
    /// <param name="scene">What is outlined is beside it.</param>
    /// <param name="other">The other flight.</param>
    /// <param name="light">Linear light of the lines.</param>
    public static PhotoScene WithOutlines(PhotoScene scene, FlightRecord other, float3 light)
    {
        return scene.With(other.Wings.Select(Outline), Reach(other));

        PhotoPart Outline(RecordedWing wing, int k)
        {
            PhotoPart part = Part(wing, PhotoSurface.Outline(1 + other.Wings.Count + k, wing.Rest, wing.Triangles, light));
            return part with { Rest = null };
        }
    }

    private static PhotoPart Part(RecordedWing wing, PhotoSurface surface) =>
        new(surface, wing.Placement.Length, wing.At, Array.ConvertAll(wing.Rest, wing.Placement.ToBody));
}
