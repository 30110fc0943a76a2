using Alate.Editor.Tests;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Drawn pictures as PNG files.</summary>
    internal static class PngOf
    {
        public static byte[] Picture(DrawnPicture picture)
        {
            Color32[] pixels = picture.ToPixels();
            var texture = new Texture2D(picture.width, picture.height);
            for (int k = 0; k < pixels.Length; k++)
                texture.SetPixel(k % picture.width, picture.height - 1 - k / picture.width, pixels[k]);
            byte[] png = texture.EncodeToPNG();
            UnityEngine.Object.DestroyImmediate(texture);
            return png;
        }
    }
}
