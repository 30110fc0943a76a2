using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures.Photos;

/// <summary>All species of the catalogue in flight, in one picture.</summary>
internal static class Gallery
{
    private const int k_Columns = 3;
    private const float k_HeightOverWidth = 0.8f, k_InsetOverWidth = 0.045f;

    /// <summary>The paper of all pictures, sRGB.</summary>
    private static readonly float3 s_Paper = new float3(0xf7, 0xf4, 0xec) / 255f;

    /// <summary>Phases and views that are chosen by eye, because they show how the wings flex. Other species of the catalogue follow in <see cref="Other"/>.</summary>
    private static readonly Exhibit[] s_Chosen =
    [
        new("monarch", 0.23, 40f, 30f),
        new("firefly", 0.24, 34f, 32f),
        new("swallowtail", 0.30, -40f, 34f),
        new("fishfly", 0.27, 38f, 30f),
        new("painted-lichen-moth", 0.25, -50f, 26f),
        new("snailfish", 0.40, -38f, 28f),
    ];

    private static readonly Exhibit[] s_Exhibits = s_Chosen.Concat(InsectCatalogue.Names.Except(s_Chosen.Select(one => one.Species)).Select(Other)).ToArray();

    /// <summary>The picture as a PNG file.</summary>
    /// <param name="width">About its width, pixels.</param>
    public static byte[] Draw(int width)
    {
        int column = width / k_Columns, row = (int)(k_HeightOverWidth * column);
        var picture = new Texture2D(k_Columns * column, (s_Exhibits.Length + k_Columns - 1) / k_Columns * row);
        for (int k = 0; k < s_Exhibits.Length; k++)
        {
            Color32[] pixels = Photo(s_Exhibits[k], new int2(column, row));
            int left = k % k_Columns * column, top = k / k_Columns * row;
            for (int pixel = 0; pixel < pixels.Length; pixel++)
                picture.SetPixel(left + pixel % column, picture.height - 1 - top - pixel / column, pixels[pixel]);
        }

        byte[] png = picture.EncodeToPNG();
        UnityEngine.Object.DestroyImmediate(picture);
        return png;
    }

    private static Exhibit Other(string species) => new(species, 0.25, 38f, 30f);

    private static Color32[] Photo(in Exhibit exhibit, int2 size)
    {
        InsectDefinition species = InsectCatalogue.Find(exhibit.Species);
        var plan = new FlightPlan { Species = species.Name, Variant = InsectVariant.Expressive, Speed = FlightPlan.CruiseOf(species) };
        using var flight = new TetheredFlight(plan, Insect.Of(plan));
        return InsectPhoto.Take(
            flight.Run(_ => { }), exhibit.Turns, new PictureView("", exhibit.Aside, exhibit.Above), size, k_InsetOverWidth * size.x,
            Shading.ToLinear(s_Paper));
    }

    /// <summary>One species.</summary>
    /// <param name="Species">Its name.</param>
    /// <param name="Turns">The phase, beats.</param>
    /// <param name="Aside">As <see cref="PictureView.Aside"/>.</param>
    /// <param name="Above">As <see cref="PictureView.Above"/>.</param>
    private readonly record struct Exhibit(string Species, double Turns, float Aside, float Above);
}
