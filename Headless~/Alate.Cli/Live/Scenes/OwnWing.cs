using Alate.Authoring;
using Alate.Fitting;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// A wing that a viewer dropped on the page: a mesh into which a skeleton is laid, or a picture from which both are made.
/// </summary>
/// <param name="Name">The file's, without its end.</param>
/// <param name="Surface">A right wing at rest.</param>
/// <param name="Colours">[vertex] Null for none.</param>
/// <param name="Skeleton">Its skeleton.</param>
/// <param name="Picture">The picture; null for a mesh.</param>
/// <param name="Remark">What the viewer should know.</param>
internal sealed record OwnWing(
    string Name, SurfaceMesh Surface, Color32[] Colours, WingSkeleton Skeleton, WingTexture Picture, string Remark)
{
    /// <summary>Most triangles of a mesh, and most pixels of a picture.</summary>
    public const int MostTriangles = 40000, MostPixels = 16_000_000;

    private const int k_LongestName = 60;

    /// <summary>Reads a file by what is in it.</summary>
    /// <exception cref="UserException">It is no wing.</exception>
    public static OwnWing Read(string name, byte[] content)
    {
        string title = Path.GetFileNameWithoutExtension(name);
        title = title.Length > k_LongestName ? title[..k_LongestName] : title;
        try
        {
            return IsPng(content) ? FromPicture(title, content) : FromMesh(title, content);
        }
        catch (Exception problem) when (problem is FormatException or ArgumentException or DecoderFallbackException)
        {
            string reason = problem is DecoderFallbackException
                ? "it is neither a PNG picture nor a text file with a mesh (OBJ)."
                : problem.Message;
            throw new UserException($"{name}: {reason.ReplaceLineEndings(" ")}");
        }
    }

    /// <summary>The insect that flies with this wing.</summary>
    public Insect Fit(InsectDefinition species, FlightPlan plan) => Insect.OfWing(species, plan, Name, Surface, Colours, Skeleton, Picture);

    private static bool IsPng(byte[] content) =>
        content.Length > 4 && content[0] == 0x89 && content[1] == 'P' && content[2] == 'N' && content[3] == 'G';

    private static OwnWing FromPicture(string name, byte[] content)
    {
        long pixels = WingTexture.CountPixels(content);
        if (pixels > MostPixels)
            throw new FormatException($"it has {pixels / 1_000_000} million pixels; at most {MostPixels / 1_000_000} million are taken.");
        var png = PngFile.Read(content);
        WingTrace trace = WingTracer.Trace(new WingPicture(png.Width, png.Height, png.Pixels), WingTracingSettings.Default);
        return new OwnWing(name, trace.Surface, null, trace.Skeleton, WingTexture.Of(content),
            Remarks(trace.Confidence, string.Join(' ', trace.Warnings)));
    }

    private static OwnWing FromMesh(string name, byte[] content)
    {
        ObjMesh mesh = ObjReader.Read(new StringReader(new UTF8Encoding(false, true).GetString(content)));
        if (mesh.Triangles.Length > 3 * MostTriangles)
            throw new FormatException($"the mesh has {mesh.Triangles.Length / 3} triangles; at most {MostTriangles} are taken.");
        SurfaceMesh surface = mesh.ToSurface(name);
        SkeletonFitSettings settings = SkeletonFitSettings.Default;
        settings.isOriginUnknown = mesh.Origin != default;
        SkeletonFit fit = SkeletonFitter.Fit(surface, settings);
        return new OwnWing(name, surface, mesh.Colours, fit.Skeleton, null, Remarks(
            fit.Confidence, string.Join(' ', fit.Warnings.Select(warning => warning.Message))));
    }

    private static string Remarks(float confidence, string warnings) =>
        FormattableString.Invariant($"Hinge, leading edge and tip were found with confidence {confidence:0.00}. {warnings}").Trim();
}
