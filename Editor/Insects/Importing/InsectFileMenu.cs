using Alate.Files;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>
    /// The menu item that saves the insect of a file from anywhere as assets that can be changed. A file inside the project is imported
    /// without it, as a prefab that follows the file.
    /// </summary>
    internal static class InsectFileMenu
    {
        private const string k_Title = "Import Insect File";

        [MenuItem("Assets/" + k_Title + "…", false, 21)]
        private static void Import()
        {
            string path = EditorUtility.OpenFilePanel(k_Title, "", "json");
            if (string.IsNullOrEmpty(path))
                return;
            try
            {
                InsectMenu.Save(InsectFile.Read(path));
            }
            catch (UserException problem)
            {
                EditorUtility.DisplayDialog(k_Title, problem.Message, "OK");
            }
        }
    }
}
