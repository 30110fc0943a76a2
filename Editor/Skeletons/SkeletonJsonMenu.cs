using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Reads and writes skeletons as JSON, from the menu of their inspector.</summary>
    internal static class SkeletonJsonMenu
    {
        private const string k_Title = "Wing Skeleton";
        private const string k_Import = "CONTEXT/WingSkeleton/Import JSON…";
        private const string k_Export = "CONTEXT/WingSkeleton/Export JSON…";

        [MenuItem(k_Import)]
        private static void Import(MenuCommand command)
        {
            string path = EditorUtility.OpenFilePanel(k_Title, "", "json");
            if (!string.IsNullOrEmpty(path))
                ShowRefusal(SkeletonFile.Read((WingSkeleton)command.context, path, new EditorUndo()));
        }

        [MenuItem(k_Export)]
        private static void Export(MenuCommand command)
        {
            var skeleton = (WingSkeleton)command.context;
            string path = EditorUtility.SaveFilePanel(k_Title, "", skeleton.name, "json");
            if (!string.IsNullOrEmpty(path))
                ShowRefusal(SkeletonFile.Write(skeleton, path));
        }

        private static void ShowRefusal(string refusal)
        {
            if (refusal != null)
                EditorUtility.DisplayDialog(k_Title, refusal, "OK");
        }
    }
}
