using UnityEngine;

namespace Alate.Cli;

/// <summary>Picture of an insect as the live view shows it at first, to be seen until that view is loaded.</summary>
internal static class FirstPicture
{
    /// <summary>Pixels of either side.</summary>
    public const int Size = 560;

    /// <summary>Side over the insect's reach: that of the view, whose camera is 4.1 away and sees 28°.</summary>
    private const float k_SideOverReach = 2.045f;

    private static readonly PictureView s_View = new("the front left", 39f, 28.6f);

    /// <summary>Draws the beginning of a beat on a clear ground; returns a PNG file.</summary>
    public static byte[] Draw(FlightRecord flight)
    {
        float reach = Math.Max(FlightPhoto.Reach(flight), flight.Insect.Body.positions.Max(place => place.magnitude));
        PhotoScene scene = FlightPhoto.Scene(flight, s_View);
        var panel = new StripPanel(0f, 0f, Size, Size, Size / (k_SideOverReach * reach), float2.zero);
        Color32[] pixels = scene.Draw(scene.PoseAt(0.0), panel, 1f, false);
        return TrueColourPng.Write(Size, Size, pixels, [flight.Insect.DisplayName], true);
    }
}
