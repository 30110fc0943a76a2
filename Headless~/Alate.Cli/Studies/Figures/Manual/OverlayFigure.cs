using Alate.Editor;
using StandIns;
using Unity.StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Scene-view tool on a monarch's wing: what it draws for a repaint, seen from above by a camera of its own.</summary>
internal static class OverlayFigure
{
    private const float k_Width = 1000f, k_Height = 640f, k_Margin = 60f;

    /// <summary>Pixels of a handle of size 1, as in Unity.</summary>
    private const float k_HandlePixels = 80f;

    private const string k_Ground = "#3b3b3b", k_Text = "#e6e6e6";

    private static readonly JointIndex[] s_Selected = [new(2, 2), new(2, 3)];

    /// <summary>Draws the wing, its rig and its shape in the downstroke, SVG.</summary>
    public static string Draw()
    {
        WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
        SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
        WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right);
        WingPreset preset = wing.CreatePreset();
        var bounds = new Bounds(surface.positions[0], Vector3.zero);
        foreach (Vector3 place in surface.positions)
            bounds.Encapsulate(place);
        float scale = Math.Min((k_Width - 2f * k_Margin) / bounds.size.x, (k_Height - 2f * k_Margin) / bounds.size.z);
        float2 Seen(Vector3 place) => new(
            0.5f * k_Width + scale * (place.x - bounds.center.x), 0.5f * k_Height - scale * (place.z - bounds.center.z));

        using var eye = new SceneEye(place => new Vector3(Seen(place).x, Seen(place).y, 1f), _ => default);
        using var session = new SkeletonSession([new SkeletonTarget(skeleton, surface, null) { Preset = preset }], new NoUndo());
        using var gui = new SkeletonSceneGui();
        SceneView view = ScriptableObject.CreateInstance<SceneView>();
        try
        {
            (DrawnMeshes.Calls, DrawnLines.Calls, DrawnLines.Labels) = ([], [], []);
            SceneEye.HandleSize = _ => k_HandlePixels / scale;
            session.Select(session.Group.Active, s_Selected);
            session.Overlay.Colours = RigColourMode.Patch;
            var repaint = new Event { type = EventType.Repaint, mousePosition = new Vector2(-9000f, 0f) };
            eye.Send(repaint, _ => gui.OnGUI(view, session));
            return Page(Seen, scale, skeleton);
        }
        finally
        {
            DrawnMeshes.Calls?.ForEach(call => UnityEngine.Object.DestroyImmediate(call.Material));
            (DrawnMeshes.Calls, DrawnLines.Calls, DrawnLines.Labels) = (null, null, null);
            SceneEye.HandleSize = null;
            foreach (UnityEngine.Object made in new UnityEngine.Object[] { view, skeleton, preset })
                UnityEngine.Object.DestroyImmediate(made);
        }
    }

    private static string Page(Func<Vector3, float2> seen, float scale, WingSkeleton skeleton)
    {
        var page = new SvgPage();
        page.Append($"<rect width=\"{k_Width}\" height=\"{k_Height}\" rx=\"14\" fill=\"{k_Ground}\"/>\n");
        foreach ((Mesh mesh, _, _, bool edges) in DrawnMeshes.Calls.FindAll(call => !call.Edges))
            Fill(page, mesh, seen);
        foreach ((Color colour, Vector3[] points) in DrawnLines.Calls.Where(call => call.Points.Length > 1))
            Stroke(page, colour, points, seen, scale, skeleton);
        foreach ((string text, Vector3 place) in DrawnLines.Labels)
        {
            string[] lines = text.Split('\n');
            float2 at = seen(place) + new float2(5f, 14f * lines.Length - 3f);
            page.Append($"<text x=\"{at.x:0.#}\" y=\"{at.y:0.#}\" font-size=\"12\" style=\"fill:{k_Text}\">{lines[^1].Trim()}</text>\n");
        }

        return page.Finish(k_Width, k_Height, "The skeleton tool on a monarch's wing");
    }

    // Triangles in the mean colours of their corners, those of one colour together.
    private static void Fill(SvgPage page, Mesh mesh, Func<Vector3, float2> seen)
    {
        Vector3[] places = mesh.vertices;
        Color32[] colours = mesh.colors32;
        int[] triangles = mesh.triangles;
        foreach (IGrouping<(string Colour, float Opacity), int> alike in Enumerable.Range(0, triangles.Length / 3).GroupBy(Colour))
        {
            string path = string.Concat(
                alike.Select(triangle => SvgPage.Path(Corners(triangle).Select(corner => seen(places[corner]))) + "Z"));
            page.Append($"<path d=\"{path}\" fill=\"{alike.Key.Colour}\" fill-opacity=\"{alike.Key.Opacity:0.##}\"/>\n");
        }

        int[] Corners(int triangle) => triangles[(3 * triangle)..(3 * triangle + 3)];

        (string, float) Colour(int triangle)
        {
            float Mean(Func<Color32, byte> channel) => Corners(triangle).Average(corner => channel(colours[corner]) / 255f);
            return (Hex(new Color(Mean(colour => colour.r), Mean(colour => colour.g), Mean(colour => colour.b))), Mean(colour => colour.a));
        }
    }

    // What has two points is a line, or a place with the size of a dot, a ring or an arrow.
    private static void Stroke(
        SvgPage page, Color colour, Vector3[] points, Func<Vector3, float2> seen, float scale, WingSkeleton skeleton)
    {
        float2 at = seen(points[0]);
        float size = points.Length == 2 ? scale * points[1].x : 0f;
        if (colour == SkeletonColours.hinge || colour == SkeletonColours.problem)
        {
            page.Append($"<circle cx=\"{at.x:0.#}\" cy=\"{at.y:0.#}\" r=\"{scale * points[1].magnitude:0.#}\" fill=\"none\" ");
            page.Append($"stroke=\"{Hex(colour)}\" stroke-width=\"2\"/>\n");
        }
        else if (colour == SkeletonColours.joint || colour == SkeletonColours.selected)
        {
            page.Append($"<rect x=\"{at.x - size:0.#}\" y=\"{at.y - size:0.#}\" width=\"{2f * size:0.#}\" height=\"{2f * size:0.#}\" ");
            page.Append($"fill=\"{Hex(colour)}\"/>\n");
        }
        else if (colour == Handles.xAxisColor)
        {
            float2 tip = seen(points[0] + points[1].x * skeleton.SpanAxis.normalized);
            page.Line(at.x, at.y, tip.x, tip.y, "#db3e1d", 3f);
        }
        else
        {
            page.Append($"<path d=\"{SvgPage.Path(points.Select(seen))}\" fill=\"none\" stroke=\"{Hex(colour)}\" ");
            page.Append($"stroke-opacity=\"{colour.a:0.##}\" stroke-width=\"{(points.Length > 2 ? 3f : 1f):0}\"/>\n");
        }
    }

    private static string Hex(Color32 colour) => $"#{colour.r:x2}{colour.g:x2}{colour.b:x2}";

    /// <summary>Undo of a picture: nothing is changed.</summary>
    private sealed class NoUndo : IUndoRecorder
    {
        public void Begin(string undoName)
        {
        }

        public void Record(UnityEngine.Object target)
        {
        }

        public void Changed(UnityEngine.Object target)
        {
        }

        public void End()
        {
        }

        public void Cancel()
        {
        }
    }
}
