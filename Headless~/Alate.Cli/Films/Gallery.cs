using UnityEngine;

namespace Alate.Cli;

/// <summary>Insects in flight, in one picture: those of the catalogue, or others.</summary>
internal static class Gallery
{
    private const int k_Columns = 3;
    private const float k_HeightOverWidth = 0.8f, k_InsetOverWidth = 0.045f;

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
    /// <param name="width">About its width, pixels.</param>
    /// <param name="hasWake">True where the vortex rings that the wings leave are shown.</param>
    /// <param name="insects">In their order; null for all of the catalogue.</param>
    public static byte[] Draw(int width, bool hasWake = false, IReadOnlyList<InsectDefinition> insects = null)
    {
        insects ??= s_Catalogue;
        int columns = Math.Min(k_Columns, insects.Count);
        int column = width / columns, row = (int)(k_HeightOverWidth * column);
        int rows = (insects.Count + columns - 1) / columns;
        var picture = new Color32[columns * column * rows * row];
        Array.Fill(picture, Paper());
        // The last row stands in the middle.
        int aside = (rows * columns - insects.Count) * column / 2;
        for (int k = 0; k < insects.Count; k++)
        {
            Color32[] pixels = Photo(insects[k], new int2(column, row), hasWake);
            int left = k % columns * column + (k / columns == rows - 1 ? aside : 0);
            for (int y = 0; y < row; y++)
                Array.Copy(pixels, y * column, picture, (k / columns * row + y) * columns * column + left, column);
        }

        return IndexedPng.Write(
            columns * column, rows * row, picture, insects.Select(insect => insect.DisplayName));
    }

    private static Color32 Paper()
    {
        var bytes = (int3)math.round(255f * Shading.Paper);
        return new Color32((byte)bytes.x, (byte)bytes.y, (byte)bytes.z, byte.MaxValue);
    }

    private static Exhibit Other(string species) => new(species, 0.25, 38f, 30f);

    private static Color32[] Photo(InsectDefinition species, int2 size, bool hasWake)
    {
        Exhibit exhibit = Array.Find(s_Chosen, one => one.Species == species.Name);
        exhibit = exhibit.Species == null ? Other(species.Name) : exhibit;
        var plan = new FlightPlan { Definition = species, Variant = InsectVariant.Expressive, Speed = FlightPlan.CruiseOf(species) };
        using var flight = new TetheredFlight(plan, Insect.Of(plan));
        FlightRecord record = flight.Run(_ => { });
        PhotoScene scene = FlightPhoto.Scene(record, new PictureView("", exhibit.Aside, exhibit.Above));
        if (hasWake)
        {
            using var wake = WakeFlight.Smooth(record, new WakePlan());
            scene = new WakePhoto(wake).AddTo(scene, exhibit.Turns);
        }

        Pose pose = scene.PoseAt(exhibit.Turns);
        return scene.Draw(pose, StripPanel.Around(pose, size, k_InsetOverWidth * size.x), 1f);
    }

    /// <summary>One species.</summary>
    /// <param name="Species">Its name.</param>
    /// <param name="Turns">The phase, beats.</param>
    /// <param name="Aside">As <see cref="PictureView.Aside"/>.</param>
    /// <param name="Above">As <see cref="PictureView.Above"/>.</param>
    private readonly record struct Exhibit(string Species, double Turns, float Aside, float Above);
}
