namespace Alate.Cli;

/// <summary>A wing of the user's with a skeleton that was found for it: in a picture or in a mesh.</summary>
/// <param name="File">The user's file.</param>
/// <param name="Surface">The mesh at rest.</param>
/// <param name="Skeleton">In the space of the mesh.</param>
internal abstract record FoundWing(string File, SurfaceMesh Surface, WingSkeleton Skeleton)
{
    /// <summary>Sentences about what was found.</summary>
    public abstract string Summary { get; }

    /// <summary>True where a picture lies on the wing.</summary>
    public abstract bool IsTextured { get; }

    /// <summary>Writes skeleton, mesh, its picture, and a drawing of what was found.</summary>
    public abstract void Write(OutputFolder folder, TracedFiles files);
}
