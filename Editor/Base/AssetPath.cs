using System;
using System.IO;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Asks the user for the path of a new asset; null when the user cancels.</summary>
    /// <param name="title">Of the dialog.</param>
    /// <param name="name">Suggested file name, without extension.</param>
    /// <param name="message">What is about to be saved.</param>
    internal delegate string AskForPath(string title, string name, string message);

    /// <summary>Places for new assets: in the user's own folder, never in a package.</summary>
    internal static class AssetPath
    {
        private const string k_Home = "Assets/", k_Extension = ".asset";

        /// <summary>Asks by the editor's own dialog.</summary>
        public static string Ask(string title, string name, string message) =>
            EditorUtility.SaveFilePanelInProject(title, name, k_Extension.Substring(1), message);

        /// <summary>Reason why an asset cannot be saved at a path; null when it can.</summary>
        public static string FindProblem(string path)
        {
            if (!path.StartsWith(k_Home, StringComparison.Ordinal))
                return $"'{path}' is not in the project's Assets folder. Packages are read-only; choose a folder below Assets.";
            return path.EndsWith(k_Extension, StringComparison.OrdinalIgnoreCase)
                ? null
                : $"'{path}' does not end in {k_Extension}.";
        }

        /// <summary>A name without the characters that file names must not have.</summary>
        public static string FileName(string name)
        {
            foreach (char forbidden in "/\\:*?\"<>|")
                name = name.Replace(forbidden, '_');
            name = name.Trim().TrimEnd('.');
            return name.Length == 0 ? "Asset" : name;
        }

        /// <summary>A path beside another, whose file name begins with that of the other.</summary>
        public static string Beside(string path, string suffix)
        {
            string stem = path.Substring(0, path.Length - Path.GetExtension(path).Length);
            return $"{stem} {FileName(suffix)}{k_Extension}";
        }
    }
}
