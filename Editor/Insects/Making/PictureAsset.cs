using System.IO;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Saves painted textures as PNG files, which are small and can be painted over.</summary>
    internal static class PictureAsset
    {
        /// <summary>Saves a readable texture, unless there is one at the path already.</summary>
        /// <returns>The imported picture.</returns>
        public static Texture2D Save(Texture2D painted, string path)
        {
            Texture2D existing = AssetDatabase.LoadAssetAtPath<Texture2D>(path);
            if (existing != null)
                return existing;
            File.WriteAllBytes(FileUtil.GetPhysicalPath(path), painted.EncodeToPNG());
            AssetDatabase.ImportAsset(path);
            var importer = (TextureImporter)AssetImporter.GetAtPath(path);
            importer.wrapMode = TextureWrapMode.Clamp;
            importer.alphaIsTransparency = true;
            importer.SaveAndReimport();
            return AssetDatabase.LoadAssetAtPath<Texture2D>(path);
        }
    }
}
