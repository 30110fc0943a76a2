namespace Alate.Cli;

/// <summary>Places of the normals in a texture of a baked insect.</summary>
internal enum BakeNormals
{
    /// <summary>In a texture of their own.</summary>
    Separate,

    /// <summary>In the lower half.</summary>
    Packed,
}
