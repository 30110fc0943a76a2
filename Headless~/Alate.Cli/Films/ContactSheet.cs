using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Sheet of an insect from all sides and from near by: four views as it flies and as it is made, three of its parts, and at rest.
/// </summary>
internal static class ContactSheet
{
    private const int k_Columns = 4;

    /// <summary>Height of a panel over its width, and the line of text below it, units.</summary>
    private const float k_Shape = 0.86f, k_Line = 26f;

    /// <summary>Widths that a view of a part shows: over the length of the body, over the wing's.</summary>
    private const float k_Head = 0.5f, k_Base = 0.34f, k_Apex = 0.3f;

    /// <summary>The sheet as a PNG file.</summary>
    /// <param name="insect">The insect.</param>
    /// <param name="width">Its width, pixels.</param>
    /// <param name="atRest">The insect with its wings folded.</param>
    public static byte[] Draw(InsectDefinition insect, int width, PhotoScene atRest)
    {
        (FlightRecord flight, double turns) = Gallery.Fly(insect);
        PhotoScene flown = FlightPhoto.Scene(flight);
        return Lay(
        [
            Whole("front", flown, new PictureView("", 0f, 8f), turns),
            Whole("side", flown, new PictureView("", 90f, 4f), turns),
            Whole("above", flown, new PictureView("", 180f, 90f), null),
            Whole("below", flown, new PictureView("", 180f, -90f), null),
            Head("head", flight, flown),
            Part("wing base", flown, new PictureView("", 150f, 60f), flight.Wings[0].Placement.Hinge,
                k_Base * flight.Wings[0].Placement.Length),
            Apex("apex", flight.Wings[0], flown),
            new("at rest", atRest, atRest.PoseAt(0.0), null, 0f),
        ], width, insect.DisplayName);
    }

    /// <summary>Sheet of parts of insects by which their materials are told, as a PNG file.</summary>
    /// <param name="width">Its width, pixels.</param>
    public static byte[] DrawMaterials(int width)
    {
        (FlightRecord monarch, FlightRecord dragonfly, FlightRecord moth) = (Fly("monarch"), Fly("dragonfly"), Fly("painted-lichen-moth"));
        PhotoScene butterfly = FlightPhoto.Scene(monarch);
        return Lay(
        [
            Apex("a wing of scales", monarch.Wings[0], butterfly),
            Apex("its underside", monarch.Wings[0], butterfly, new PictureView("", 180f, -90f)),
            Apex("a clear wing", dragonfly.Wings[0], FlightPhoto.Scene(dragonfly)),
            Head("a body", moth, FlightPhoto.Scene(moth)),
        ], width, "Materials of wings and bodies");

        FlightRecord Fly(string insect) => Gallery.Fly(InsectCatalogue.Find(insect)).Flight;
    }

    private static byte[] Lay(View[] views, int width, string title)
    {
        var page = new PixelPage();
        float panel = width / PixelPage.Fineness / k_Columns, row = k_Shape * panel + k_Line;
        for (int k = 0; k < views.Length; k++)
        {
            float left = k % k_Columns * panel, top = k / k_Columns * row;
            var shown = StripPanel.Around(views[k].Pose, new float2(panel, k_Shape * panel), 6f);
            if (views[k].At is { } at)
                shown = shown with { Scale = panel / views[k].Shown, Centre = views[k].Scene.Project(at).xy };
            page.Add(views[k].Scene, views[k].Pose, shown with { Left = left, Top = top });
            page.Text(left + 0.5f * panel, top + row - 9f, 14f, views[k].Name, "middle", "t");
        }

        return page.Finish(width / PixelPage.Fineness, (views.Length + k_Columns - 1) / k_Columns * row, title);
    }

    private static View Whole(string name, PhotoScene flown, PictureView view, double? turns)
    {
        PhotoScene scene = flown.From(view);
        return new(name, scene, turns is { } phase ? scene.PoseAt(phase) : scene.Rest(), null, 0f);
    }

    private static View Head(string name, FlightRecord flight, PhotoScene flown) =>
        Part(name, flown, new PictureView("", 38f, 22f), Head(flight), k_Head * BodyLength(flight));

    private static View Apex(string name, RecordedWing wing, PhotoScene flown, PictureView? view = null) =>
        Part(name, flown, view ?? new PictureView("", 180f, 90f), Apex(wing), k_Apex * wing.Placement.Length);

    private static View Part(string name, PhotoScene flown, PictureView view, float3 at, float wide)
    {
        PhotoScene scene = flown.From(view);
        return new(name, scene, scene.Rest(), at, wide);
    }

    private static float BodyLength(FlightRecord flight) =>
        flight.Insect.Body.positions.Max(place => place.z) - flight.Insect.Body.positions.Min(place => place.z);

    // Between the eyes: the foremost tenth of the body, without antennae, which are slender.
    private static float3 Head(FlightRecord flight)
    {
        Vector3[] places = flight.Insect.Body.positions;
        float front = places.Select(place => place.z).Order().ElementAt((int)(0.9f * places.Length)), length = BodyLength(flight);
        return new float3(0f, places.Where(place => place.z > front).Select(place => place.y).Order().ElementAt(places.Length / 20),
            front - 0.02f * length);
    }

    private static float3 Apex(RecordedWing wing)
    {
        float3[] rest = Array.ConvertAll(wing.Rest, wing.Placement.ToBody);
        float3 tip = rest.MaxBy(place => math.abs(place.x));
        return tip - math.sign(tip.x) * new float3(0.1f * wing.Placement.Length, 0f, 0f);
    }

    /// <summary>A view of an insect.</summary>
    /// <param name="Name">What it shows.</param>
    /// <param name="Scene">The insect from there.</param>
    /// <param name="Pose">Its pose.</param>
    /// <param name="At">Place in the middle, metres on the body; null for all of it.</param>
    /// <param name="Shown">Width that is shown around that place, metres.</param>
    private readonly record struct View(string Name, PhotoScene Scene, Pose Pose, float3? At, float Shown);
}
