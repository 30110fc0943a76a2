using UnityEngine;

namespace UnityEditor;

public sealed class TextureImporter : AssetImporter
{
    public TextureWrapMode wrapMode { get; set; }
    public bool alphaIsTransparency { get; set; }
}
