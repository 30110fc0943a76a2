using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Reads the picture of a wing from a texture's own file, in full size and whatever its import settings. Falls back to the texture
    /// itself where its file is of a kind that cannot be read.
    /// </summary>
    internal static class WingImageFile
    {
        /// <summary>Makes a readable copy, which the caller destroys.</summary>
        /// <exception cref="FormatException">Neither the file nor the texture can be read; the message is for the user.</exception>
        public static Texture2D Read(Texture2D texture)
        {
            string path = AssetDatabase.GetAssetPath(texture);
            string file = string.IsNullOrEmpty(path) ? null : FileUtil.GetPhysicalPath(path);
            return Read(texture, file != null && File.Exists(file) ? File.ReadAllBytes(file) : null);
        }

        /// <summary>Makes a readable copy, which the caller destroys.</summary>
        /// <param name="texture">The texture.</param>
        /// <param name="content">Of its file; null when there is none.</param>
        /// <exception cref="FormatException">Neither can be read.</exception>
        public static Texture2D Read(Texture2D texture, byte[] content)
        {
            var copy = new Texture2D(2, 2) { name = texture.name, hideFlags = HideFlags.HideAndDontSave };
            if (content != null && copy.LoadImage(content))
                return copy;
            UnityEngine.Object.DestroyImmediate(copy);
            if (!texture.isReadable)
            {
                throw new FormatException(
                    $"The file of '{texture.name}' cannot be read as a PNG or JPEG picture; save it as one, or turn on Read/Write in its "
                    + "import settings.");
            }

            var same = new Texture2D(texture.width, texture.height) { name = texture.name, hideFlags = HideFlags.HideAndDontSave };
            same.SetPixels32(texture.GetPixels32());
            same.Apply();
            return same;
        }
    }
}
