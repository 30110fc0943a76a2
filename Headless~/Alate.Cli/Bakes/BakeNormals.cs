namespace Alate.Cli.Bakes;

/// <summary>Where a texture of a baked insect has its normals.</summary>
internal enum BakeNormals
{
    /// <summary>In a texture of their own.</summary>
    Separate,

    /// <summary>In the lower half.</summary>
    Packed,
}
