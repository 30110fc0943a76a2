using Alate.Authoring;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A file that shows a wing of the user's, with what the user says of it.</summary>
/// <param name="File">A picture, or a mesh where it ends in .obj or .glb.</param>
/// <param name="Hinge">
/// Where the wing turns: pixels from the picture's top left corner, or three numbers in the space of the mesh; null to find it.
/// </param>
/// <param name="Leading">The leading edge's side of a picture, y down; null to find it.</param>
/// <param name="Triangles">Triangles of the mesh of a picture, most of another one; null for a thousand, and for all.</param>
internal sealed record WingSource(string File, double[] Hinge = null, Vector2? Leading = null, int? Triangles = null)
{
    /// <summary>Word for what is to be found.</summary>
    private const string k_Auto = "auto";

    /// <summary>Sides of a picture, as directions in it, y down.</summary>
    public static readonly Dictionary<string, Vector2> Sides = new()
    {
        ["up"] = new Vector2(0f, -1f),
        ["down"] = new Vector2(0f, 1f),
        ["left"] = new Vector2(-1f, 0f),
        ["right"] = new Vector2(1f, 0f),
    };

    /// <summary>True for a mesh, false for a picture.</summary>
    public bool IsMesh => ObjMesh.IsNamed(File) || GlbMesh.IsNamed(File);

    /// <summary>Reads what options say of wings.</summary>
    /// <param name="files">Of the wings, from front to back.</param>
    /// <param name="hinges">A place for each wing, or "auto"; fewer than wings for the first ones alone.</param>
    /// <param name="sides">Likewise, a side of the picture.</param>
    /// <param name="triangles">Of each mesh; null for what they have.</param>
    /// <exception cref="UserException">There are more than wings, or one is no place or side.</exception>
    public static WingSource[] Read(string[] files, string[] hinges, string[] sides, int? triangles)
    {
        foreach ((string option, int count) in new[] { ("--hinge", hinges.Length), ("--leading", sides.Length) })
        {
            if (count > files.Length)
                throw new UserException($"{option} takes one for each wing: {files.Length}, not {count}.");
        }

        WingSource[] sources = Array.ConvertAll(files, file => new WingSource(file, Triangles: triangles));
        for (int k = 0; k < hinges.Length; k++)
            sources[k] = hinges[k] == k_Auto ? sources[k] : sources[k] with { Hinge = PlaceOf(hinges[k], sources[k]) };
        for (int k = 0; k < sides.Length; k++)
            sources[k] = sides[k] == k_Auto ? sources[k] : sources[k] with { Leading = SideOf(sides[k], sources[k]) };
        return sources;
    }

    /// <summary>Finds the wing.</summary>
    /// <exception cref="UserException">The file cannot be read, or shows no wing.</exception>
    public FoundWing Find()
    {
        if (IsMesh)
            return FittedWing.Of(File, Hinge, Triangles);
        WingTracingSettings settings = WingTracingSettings.Default;
        settings.triangles = Triangles ?? settings.triangles;
        settings.hinge = Hinge == null ? null : new Vector2((float)Hinge[0], (float)Hinge[1]);
        settings.forward = Leading;
        return TracedWing.Of(File, settings);
    }

    private static double[] PlaceOf(string text, WingSource of)
    {
        int count = of.IsMesh ? 3 : 2;
        double[] numbers = NumberText.WithCommas(text);
        return numbers.Length == count && numbers.All(double.IsFinite) ? numbers : throw new UserException(of.IsMesh
            ? $"--hinge of {of.File} takes X,Y,Z in the space of the mesh or '{k_Auto}', not {Quote.Of(text)}."
            : $"--hinge of {of.File} takes X,Y, pixels from the picture's top left corner, or '{k_Auto}', not {Quote.Of(text)}.");
    }

    private static Vector2 SideOf(string text, WingSource of)
    {
        if (of.IsMesh)
            throw new UserException($"--leading is the side of a picture; the leading edge of {of.File}, a mesh, is that towards +Z.");
        return Sides.TryGetValue(text.ToLowerInvariant(), out Vector2 side) ? side : throw new UserException(
            $"--leading of {of.File} takes {string.Join(", ", Sides.Keys)} or {k_Auto}, not {Quote.Of(text)}.");
    }
}
