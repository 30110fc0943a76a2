using System;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Finds and makes folders for new assets: below the user's own Assets, never in a package, which is read-only when it was installed
    /// from git.
    /// </summary>
    internal static class AssetFolder
    {
        private const string k_Home = "Assets";

        /// <summary>Reason why nothing can be saved in a folder; null when saving works.</summary>
        public static string FindProblem(string folder)
        {
            return folder == k_Home || folder.StartsWith(k_Home + "/", StringComparison.Ordinal)
                ? null
                : $"'{folder}' is not in the project's Assets folder. Packages are read-only; choose a folder below Assets.";
        }

        /// <summary>Makes a folder and all missing folders above it.</summary>
        public static void Ensure(string folder)
        {
            if (AssetDatabase.IsValidFolder(folder))
                return;
            int end = folder.LastIndexOf('/');
            string parent = folder.Substring(0, end);
            Ensure(parent);
            AssetDatabase.CreateFolder(parent, folder.Substring(end + 1));
        }

        /// <summary>
        /// Folder that is selected in the project window, or that of the selected asset; Assets where that is not the user's.
        /// </summary>
        public static string Of(Object selected)
        {
            string path = selected == null ? "" : AssetDatabase.GetAssetPath(selected);
            int end = path.LastIndexOf('/');
            string folder = AssetDatabase.IsValidFolder(path) ? path : end > 0 ? path.Substring(0, end) : k_Home;
            return FindProblem(folder) == null ? folder : k_Home;
        }
    }
}
