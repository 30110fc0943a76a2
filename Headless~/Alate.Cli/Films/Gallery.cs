using UnityEngine;

namespace Alate.Cli;

/// <summary>Insects in flight, in one picture: those of the catalogue, or others.</summary>
internal static class Gallery
{
    private const float k_HeightOverWidth = 0.72f, k_GapOverWidth = 0.03f, k_Inset = 2f;

    /// <summary>
    /// Phases and views that are chosen by eye, because they show how the wings flex. Other species of the catalogue follow in
    /// <see cref="Other"/>.
    /// </summary>
    private static readonly Exhibit[] s_Chosen =
    [
        new("monarch", 0.23, 40f, 30f),
        new("firefly", 0.24, 34f, 32f),
        new("swallowtail", 0.30, -40f, 34f),
        new("fishfly", 0.27, 38f, 30f),
        new("painted-lichen-moth", 0.25, -50f, 26f),
        new("snailfish", 0.40, -38f, 28f),
    ];

    private static readonly InsectDefinition[] s_Catalogue = s_Chosen.Select(one => one.Species)
        .Concat(InsectCatalogue.Names.Except(s_Chosen.Select(one => one.Species))).Select(InsectCatalogue.Find).ToArray();

    /// <summary>The picture as a PNG file.</summary>
    /// <param name="width">Its width, pixels.</param>
    /// <param name="hasWake">True where the vortex rings that the wings leave are shown.</param>
    /// <param name="insects">In their order; null for all of the catalogue.</param>
    /// <param name="hasPaper">False where nothing lies behind them.</param>
    /// <param name="backdrop">Wall behind them; null for paper or nothing.</param>
    public static byte[] Draw(
        int width, bool hasWake = false, IReadOnlyList<InsectDefinition> insects = null, bool hasPaper = true,
        BackdropLook? backdrop = null)
    {
        insects ??= s_Catalogue;
        (PhotoScene Scene, Pose Pose)[] photos = [.. insects.Select(insect => Photo(insect, hasWake))];
        var rows = new JustifiedRows([.. photos.Select(photo => Aspect(photo.Pose))], width, k_GapOverWidth * width, k_HeightOverWidth);
        int height = (int)math.ceil(rows.Height);
        int2[] corners = [.. photos.Select((_, k) => (int2)math.round(rows[k].Corner))], sizes =
            [.. photos.Select((_, k) => (int2)math.floor(rows[k].Size))];
        StripPanel[] panels = [.. photos.Select((photo, k) => StripPanel.Around(photo.Pose, sizes[k], k_Inset))];
        Color32[] Painted(int k, bool onPaper) => photos[k].Scene.Draw(photos[k].Pose, panels[k], 1f, onPaper);
        Color32[] picture;
        if (backdrop is { } look)
        {
            var wall = new Backdrop(look, new int2(width, height));
            for (int k = 0; k < photos.Length; k++)
                wall.Shade(photos[k].Scene, photos[k].Pose, panels[k], 1f, corners[k]);
            for (int k = 0; k < photos.Length; k++)
                wall.Lay(Painted(k, false), sizes[k], corners[k]);
            picture = wall.Pixels();
        }
        else
        {
            picture = new Color32[width * height];
            if (hasPaper)
                Array.Fill(picture, Shading.Bytes(Shading.Paper));
            for (int k = 0; k < photos.Length; k++)
            {
                Color32[] pixels = Painted(k, hasPaper);
                for (int y = 0; y < sizes[k].y; y++)
                    Array.Copy(pixels, y * sizes[k].x, picture, (corners[k].y + y) * width + corners[k].x, sizes[k].x);
            }
        }

        return TrueColourPng.Write(width, height, picture, insects.Select(insect => insect.DisplayName), !hasPaper);
    }

    private static float Aspect(Pose pose)
    {
        (float2 min, float2 max) = pose.Bounds();
        return (max.x - min.x) / (max.y - min.y);
    }

    /// <summary>Flies an insect for a picture; returns the phase that shows how its wings flex, too.</summary>
    public static (FlightRecord Flight, double Turns) Fly(InsectDefinition species)
    {
        var plan = new FlightPlan { Definition = species, Variant = InsectVariant.Expressive, Speed = FlightPlan.CruiseOf(species) };
        using var flight = new TetheredFlight(plan, Insect.Of(plan));
        return (flight.Run(_ => { }), ExhibitOf(species).Turns);
    }

    private static Exhibit ExhibitOf(InsectDefinition species)
    {
        Exhibit exhibit = Array.Find(s_Chosen, one => one.Species == species.Name);
        return exhibit.Species == null ? Other(species.Name) : exhibit;
    }

    private static Exhibit Other(string species) => new(species, 0.25, 38f, 30f);

    private static (PhotoScene Scene, Pose Pose) Photo(InsectDefinition species, bool hasWake)
    {
        Exhibit exhibit = ExhibitOf(species);
        FlightRecord record = Fly(species).Flight;
        PhotoScene scene = FlightPhoto.Scene(record, new PictureView("", exhibit.Aside, exhibit.Above));
        if (hasWake)
        {
            using var wake = WakeFlight.Smooth(record, new WakePlan());
            scene = new WakePhoto(wake).AddTo(scene, exhibit.Turns);
        }

        return (scene, scene.PoseAt(exhibit.Turns));
    }

    /// <summary>One species.</summary>
    /// <param name="Species">Its name.</param>
    /// <param name="Turns">The phase, beats.</param>
    /// <param name="Aside">As <see cref="PictureView.Aside"/>.</param>
    /// <param name="Above">As <see cref="PictureView.Above"/>.</param>
    private readonly record struct Exhibit(string Species, double Turns, float Aside, float Above);
}
