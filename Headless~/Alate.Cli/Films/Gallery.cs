using UnityEngine;

namespace Alate.Cli;

/// <summary>All species of the catalogue in flight, in one picture.</summary>
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

    private static readonly Exhibit[] s_Exhibits = s_Chosen
        .Concat(InsectCatalogue.Names.Except(s_Chosen.Select(one => one.Species)).Select(Other)).ToArray();

    /// <summary>The picture as a PNG file.</summary>
    /// <param name="width">About its width, pixels.</param>
    /// <param name="hasWake">True where the vortex rings that the wings leave are shown.</param>
    public static byte[] Draw(int width, bool hasWake = false)
    {
        int column = width / k_Columns, row = (int)(k_HeightOverWidth * column);
        int rows = (s_Exhibits.Length + k_Columns - 1) / k_Columns;
        var picture = new Color32[k_Columns * column * rows * row];
        Array.Fill(picture, Paper());
        // The last row stands in the middle.
        int aside = (rows * k_Columns - s_Exhibits.Length) * column / 2;
        for (int k = 0; k < s_Exhibits.Length; k++)
        {
            Color32[] pixels = Photo(s_Exhibits[k], new int2(column, row), hasWake);
            int left = k % k_Columns * column + (k / k_Columns == rows - 1 ? aside : 0);
            for (int y = 0; y < row; y++)
                Array.Copy(pixels, y * column, picture, (k / k_Columns * row + y) * k_Columns * column + left, column);
        }

        return IndexedPng.Write(
            k_Columns * column, rows * row, picture, s_Exhibits.Select(one => InsectCatalogue.Find(one.Species).DisplayName));
    }

    private static Color32 Paper()
    {
        var bytes = (int3)math.round(255f * Shading.Paper);
        return new Color32((byte)bytes.x, (byte)bytes.y, (byte)bytes.z, byte.MaxValue);
    }

    private static Exhibit Other(string species) => new(species, 0.25, 38f, 30f);

    private static Color32[] Photo(in Exhibit exhibit, int2 size, bool hasWake)
    {
        InsectDefinition species = InsectCatalogue.Find(exhibit.Species);
        var plan = new FlightPlan { Species = species.Name, Variant = InsectVariant.Expressive, Speed = FlightPlan.CruiseOf(species) };
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
