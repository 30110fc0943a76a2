namespace Alate.Cli;

/// <summary>File formats of baked insects.</summary>
internal enum BakeFormat
{
    /// <summary>A folder of textures that hold where each vertex is, with a mesh.</summary>
    OpenVat,

    /// <summary>A glTF file with joints.</summary>
    GltfSkin,

    /// <summary>A glTF file with a shape a key frame.</summary>
    GltfMorph,

    /// <summary>A folder with a USD file with joints and the pictures on it.</summary>
    Usd,
}
