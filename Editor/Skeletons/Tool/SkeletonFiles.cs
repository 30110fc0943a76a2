using System.IO;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Saves new skeletons into the user's own project.</summary>
    internal static class SkeletonFiles
    {
        private const string k_Assets = "Assets/";

        /// <summary>Asks where to save a skeleton, beside another one if that lies in the project. False where the user declines.</summary>
        public static bool Save(WingSkeleton skeleton, WingSkeleton beside)
        {
            string folder = FolderOf(beside == null ? null : AssetDatabase.GetAssetPath(beside));
            string path = EditorUtility.SaveFilePanelInProject(
                "Save Wing Skeleton", skeleton.name, "asset", "Where to save the skeleton.", folder);
            if (string.IsNullOrEmpty(path))
                return false;
            AssetDatabase.CreateAsset(skeleton, path);
            AssetDatabase.SaveAssetIfDirty(skeleton);
            return true;
        }

        /// <summary>The folder of a path within Assets; Assets itself for any other path.</summary>
        public static string FolderOf(string path)
        {
            if (string.IsNullOrEmpty(path) || !path.StartsWith(k_Assets, System.StringComparison.Ordinal))
                return "Assets";
            return Path.GetDirectoryName(path).Replace('\\', '/');
        }
    }
}
