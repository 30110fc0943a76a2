using Alate.Authoring;

namespace Alate.Cli;

/// <summary>A wing that was traced in a picture of the user's.</summary>
/// <param name="Picture">The picture.</param>
/// <param name="Trace">What was found in it.</param>
internal sealed record TracedWing(PictureFile Picture, WingTrace Trace) : FoundWing(Picture.Path, Trace.Surface, Trace.Skeleton)
{
    /// <summary>Traces a picture.</summary>
    /// <exception cref="UserException">The file cannot be read, or shows no wing.</exception>
    public static TracedWing Of(string file, in WingTracingSettings settings)
    {
        var picture = PictureFile.Read(file);
        try
        {
            return new TracedWing(picture, WingTracer.Trace(picture.Picture, settings));
        }
        catch (Exception problem) when (problem is FormatException or ArgumentException)
        {
            throw new UserException($"{file}: {problem.Message}");
        }
    }

    public override bool IsTextured => true;

    public override string Summary
    {
        get
        {
            var text = new StringBuilder();
            text.Append(CultureInfo.InvariantCulture, $"{Trace.Surface.TriangleCount} triangles, ");
            text.Append(CultureInfo.InvariantCulture, $"{Trace.Skeleton.ChainCount} chains of {Trace.Skeleton.JointsPerChain} joints, ");
            text.Append(CultureInfo.InvariantCulture, $"{Trace.FollowsVein.Count(follows => follows)} of them along veins, ");
            text.Append(CultureInfo.InvariantCulture, $"confidence {Trace.Confidence:0.00}.");
            foreach (string warning in Trace.Warnings)
                text.Append(' ').Append(warning);
            return text.ToString();
        }
    }

    /// <summary>Writes skeleton, mesh with its material and picture, and the overlay.</summary>
    public override void Write(OutputFolder folder, TracedFiles files)
    {
        void Text(string name, string text) => folder.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        Text(files.Skeleton, SkeletonJson.Write(Trace.Skeleton));
        folder.Write(files.Mesh, stream => ObjWriter.Write(Trace.Surface, stream, files.Library, files.Name));
        Text(files.Library, ObjMaterial.Write(files.Name, files.Picture));
        folder.Write(files.Picture, stream => stream.Write(TracedTexture.Png(Picture, Trace.Outline)));
        Text(files.Overlay, TracePicture.Draw(Picture, Trace));
    }
}
