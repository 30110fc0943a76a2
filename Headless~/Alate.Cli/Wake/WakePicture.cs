namespace Alate.Cli;

/// <summary>wake.png: the insect at the end of its downstroke with the rings of its wake, from its corner and from its side.</summary>
internal static class WakePicture
{
    private const float k_Panel = 560f, k_Header = 62f, k_Edge = 26f, k_Foot = 20f;

    /// <summary>Phase of the picture, beats.</summary>
    private const double k_Phase = 0.5;

    /// <summary>The whole picture.</summary>
    /// <param name="wake">A wake that has been shed.</param>
    public static byte[] Draw(WakeFlight wake) => Compose(wake).Write();

    internal static PixelPage Compose(WakeFlight wake)
    {
        var photo = new WakePhoto(wake);
        string name = wake.Flight.Insect.DisplayName;
        PictureView[] views = [wake.Flight.Plan.View, PictureView.ByName["side"]];
        List<PhotoScene> scenes = [.. views.Select(view => photo.AddTo(FlightPhoto.Scene(wake.Flight, view), k_Phase))];
        List<Pose> poses = scenes.ConvertAll(scene => scene.PoseAt(k_Phase));
        var layout = new StripLayout(poses, poses.Count, 0f, k_Header, k_Panel, 0f);
        var page = new PixelPage();
        page.Text(k_Edge, 38f, 22f, name, look: "b");
        page.Text(
            layout.Width - k_Edge, 37f, 13f, string.Create(
                CultureInfo.InvariantCulture,
                $"vortex rings of {WakePhoto.Beats:0.#} beats that turn one way and the other, "
                + $"up to {1e4f * photo.Strongest:0} cm²/s"), "end");
        for (int k = 0; k < poses.Count; k++)
            page.Add(scenes[k], poses[k], layout[k]);
        return page.End(layout.Width, layout.Height + k_Foot, $"{name} and the vortex rings of its wake");
    }
}
