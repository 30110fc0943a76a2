namespace Alate.Cli;

/// <summary>wake.png: the insect at the end of its downstroke with the rings of its wake, from its corner and from its side.</summary>
internal static class WakePicture
{
    private const float k_Panel = 560f, k_Header = 62f, k_Edge = 26f, k_Foot = 20f;

    /// <summary>Share of its density that the oldest wake has lost: it is the most tangled.</summary>
    private const float k_Faded = 0.85f;

    /// <summary>Phase of the picture, and oldest wake in it, beats.</summary>
    private const double k_Phase = 0.5, k_Beats = 1.5;

    /// <summary>The whole picture.</summary>
    /// <param name="wake">A wake that has been shed.</param>
    public static byte[] Draw(WakeFlight wake) => Compose(wake).Write();

    internal static PixelPage Compose(WakeFlight wake)
    {
        int steps = wake.Plan.StepsPerBeat, step = (int)Math.Round(k_Phase * steps);
        List<ShapedSheet> sheets = wake.Shapes[step].ConvertAll(sheet => sheet.Newest((int)(k_Beats * steps) + 1));
        float strongest = WakeColours.Strongest(sheets);
        float reach = sheets.Max(sheet => sheet.Points.Max(math.length));
        string name = wake.Flight.Insect.DisplayName;
        PictureView[] views = [wake.Flight.Plan.View, PictureView.ByName["side"]];
        List<PhotoScene> scenes = [.. views.Select(view => FlightPhoto.Scene(wake.Flight, view)
            .With(sheets.Select((sheet, k) => Part(sheet, wake.Flight.Wings.Count + 1 + k, strongest)), reach))];
        List<Pose> poses = scenes.ConvertAll(scene => scene.PoseAt((double)step / steps));
        var layout = new StripLayout(poses, poses.Count, 0f, k_Header, k_Panel, 0f);
        var page = new PixelPage();
        page.Text(k_Edge, 38f, 22f, name, look: "b");
        page.Text(
            layout.Width - k_Edge, 37f, 13f, string.Create(
                CultureInfo.InvariantCulture,
                $"vortex rings of {k_Beats:0.#} beats that turn one way and the other, up to {1e4f * strongest:0} cm²/s"), "end");
        for (int k = 0; k < poses.Count; k++)
            page.Add(scenes[k], poses[k], layout[k]);
        return page.End(layout.Width, layout.Height + k_Foot, $"{name} and the vortex rings of its wake");
    }

    private static PhotoPart Part(ShapedSheet sheet, int index, float strongest)
    {
        float4[] colours = new float4[sheet.Points.Length];
        for (int k = 0; k < colours.Length; k++)
        {
            int row = Math.Min(k / sheet.Width, sheet.Rows - 2);
            var shown = WakeColours.Of(sheet.CirculationAt(row, k % sheet.Width) / strongest);
            colours[k] = new float4(Shading.ToLinear(shown.xyz), (1f - k_Faded * row / sheet.Rows) * shown.w);
        }

        float3[] normals = Array.ConvertAll(sheet.Points, _ => new float3(0f, 1f, 0f));
        int[] triangles = Triangles(sheet.Rows, sheet.Width);
        return new PhotoPart(
            PhotoSurface.Thin(index, sheet.Points, triangles, colours, (colour, _) => colour, hasEdge: false), 1f,
            _ => (sheet.Points, normals), sheet.Points);
    }

    private static int[] Triangles(int rows, int width)
    {
        var triangles = new List<int>();
        for (int row = 0; row + 1 < rows; row++)
        {
            for (int k = 0; k + 1 < width; k++)
            {
                int at = row * width + k;
                triangles.AddRange([at, at + 1, at + width, at + 1, at + width + 1, at + width]);
            }
        }

        return [.. triangles];
    }
}
