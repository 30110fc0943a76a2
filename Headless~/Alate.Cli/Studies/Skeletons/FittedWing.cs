using Alate.Authoring;
using Alate.Fitting;

namespace Alate.Cli;

/// <summary>A mesh of a wing of the user's into which a skeleton was laid.</summary>
internal sealed record FittedWing : FoundWing
{
    private readonly ObjMesh m_Mesh;
    private readonly byte[] m_Obj;
    private readonly SkeletonFit m_Fit;
    private readonly PictureFile m_Picture;

    private FittedWing(string file, ObjMesh mesh, byte[] obj, SurfaceMesh surface, SkeletonFit fit, PictureFile picture)
        : base(file, surface, fit.Skeleton)
    {
        m_Mesh = mesh;
        m_Obj = obj;
        m_Fit = fit;
        m_Picture = picture;
    }

    public override string Summary => $"{Surface.TriangleCount} triangles, {Describe(m_Fit)}";

    public override bool IsTextured => m_Picture != null;

    /// <summary>Lays a skeleton into the mesh of a file.</summary>
    /// <param name="file">OBJ or GLB.</param>
    /// <param name="hinge">Where the wing turns, in the file's space; null to find it.</param>
    /// <param name="triangles">Most triangles: a mesh of more is made smaller; null keeps all.</param>
    /// <exception cref="UserException">The file cannot be read, or no skeleton fits.</exception>
    public static FittedWing Of(string file, double[] hinge, int? triangles)
    {
        if (GlbMesh.IsNamed(file))
            return OfGlb(file, hinge, triangles);
        ObjMesh mesh = TextFile.Read(file, ObjReader.Read, InputFile.Mesh);
        string picture = mesh.Uvs == null ? null : ObjMaterial.FindPicture(file, mesh.Library, InputFiles.Instance);
        return Of(file, mesh, null, picture == null ? null : PictureFile.Read(picture), hinge, triangles);
    }

    // As the OBJ file that is written of it.
    private static FittedWing OfGlb(string file, double[] hinge, int? triangles)
    {
        var glb = GlbMesh.Read(file);
        byte[] obj = glb.ToObj();
        ObjMesh mesh = Parsed(obj);
        PictureFile picture = mesh.Uvs == null || glb.Picture == null ? null : PictureFile.Within(file, glb.Picture);
        return Of(file, mesh, obj, picture, hinge, triangles);
    }

    private static FittedWing Of(string file, ObjMesh mesh, byte[] obj, PictureFile picture, double[] hinge, int? triangles)
    {
        SkeletonFitSettings settings = SkeletonFitSettings.Default;
        settings.isOriginUnknown = mesh.Origin != default;
        settings.hinge = mesh.Placed(hinge);
        if (mesh.TriangleCount > (triangles ?? WingFiles.MostTriangles))
        {
            obj = SmallerMesh.Of(mesh, triangles
                ?? throw new UserException(
                    $"{WingFiles.TooMany(file, mesh)} --triangles N writes a smaller mesh; 5000 show all of most wings."));
            mesh = Parsed(obj);
        }

        SurfaceMesh surface = mesh.ToSurface(file);
        return new FittedWing(file, mesh, obj, surface, Fit(surface, settings), picture);
    }

    private static ObjMesh Parsed(byte[] obj)
    {
        using var text = new StreamReader(new MemoryStream(obj));
        return ObjReader.Read(text);
    }

    /// <summary>Lays a skeleton into a mesh.</summary>
    /// <exception cref="UserException">None fits.</exception>
    public static SkeletonFit Fit(SurfaceMesh surface, in SkeletonFitSettings settings)
    {
        try
        {
            return SkeletonFitter.Fit(surface, settings);
        }
        catch (ArgumentException problem)
        {
            throw new UserException(problem.Message);
        }
    }

    /// <summary>One line: the confidence and all warnings.</summary>
    public static string Describe(SkeletonFit fit)
    {
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $"{fit.Skeleton.ChainCount} chains of {fit.Skeleton.JointsPerChain} joints, ");
        text.Append(CultureInfo.InvariantCulture, $"confidence {fit.Confidence:0.00}.");
        foreach (SkeletonFitWarning warning in fit.Warnings)
            text.Append($" {warning.Kind}: {warning.Message}");
        return text.ToString();
    }

    /// <summary>Writes the skeleton, the mesh, an OBJ as it is, its picture, and the drawing.</summary>
    public override void Write(OutputFolder folder, TracedFiles files)
    {
        void Text(string name, string text) => folder.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        Text(files.Skeleton, SkeletonJson.Write(Skeleton, m_Mesh.Origin));
        folder.Write(files.Mesh, stream =>
        {
            if (m_Obj == null)
                InputFile.Copy(File, InputFile.Mesh, stream);
            else
                stream.Write(m_Obj);
        });
        if (IsTextured)
            folder.Write(files.Picture, stream => stream.Write(m_Picture.Bytes));
        Text(files.Overlay, SkeletonPicture.Draw(m_Fit));
    }
}
