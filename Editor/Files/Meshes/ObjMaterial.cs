using System;
using System.IO;
using System.Linq;

namespace Alate.Files
{
    /// <summary>Finds the picture on a Wavefront OBJ file's material.</summary>
    internal static class ObjMaterial
    {
        private const string k_Picture = "map_Kd";

        private static readonly string[] s_Endings = { ".png", ".jpg", ".jpeg" };

        /// <summary>Text of a library with one material of a picture.</summary>
        public static string Write(string name, string picture) => $"newmtl {name}\nKd 1 1 1\n{k_Picture} {picture}\n";

        /// <summary>Path of the first picture that the material library of a mesh names; null where there is none on the disk.</summary>
        /// <param name="mesh">Path of the mesh.</param>
        /// <param name="library">Name of its library; null for none.</param>
        /// <param name="files">Finds and reads them.</param>
        public static string FindPicture(string mesh, string library, FileSource files)
        {
            if (library == null)
                return null;
            string folder = Path.GetDirectoryName(mesh) ?? "", path = Path.Combine(folder, library);
            if (!files.Contains(path))
                return null;
            string line = files.ReadText(path, reader => reader.ReadToEnd().Split('\n'))
                .Select(text => text.Trim()).FirstOrDefault(text => text.StartsWith(k_Picture + ' ', StringComparison.Ordinal));
            string picture = line == null ? null : Path.Combine(folder, line.Substring(k_Picture.Length + 1).Trim());
            bool isPicture = picture != null && s_Endings.Contains(Path.GetExtension(picture).ToLowerInvariant());
            return isPicture && files.Contains(picture) ? picture : null;
        }
    }
}
