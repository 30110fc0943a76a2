using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Reads the air of a wake into a preset, from the menu of its inspector.</summary>
    internal static class InflowMenu
    {
        private const string k_Title = "Wing Preset";
        private const string k_Read = "CONTEXT/WingPreset/Read Inflow…";

        [MenuItem(k_Read)]
        private static void Read(MenuCommand command)
        {
            string path = EditorUtility.OpenFilePanel(k_Title, "", "json");
            if (string.IsNullOrEmpty(path))
                return;
            string refusal = InflowFile.Read((WingPreset)command.context, path);
            if (refusal != null)
                EditorUtility.DisplayDialog(k_Title, refusal, "OK");
        }
    }
}
