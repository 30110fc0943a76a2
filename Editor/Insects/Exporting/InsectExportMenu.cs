using System;
using System.IO;
using Alate.Files;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>The menu item of Insect Wings that writes the insect as an insect file.</summary>
    internal static class InsectExportMenu
    {
        private const string k_Title = "Export Insect File";

        [MenuItem("CONTEXT/InsectWings/" + k_Title + "…")]
        private static void Export(MenuCommand command)
        {
            var insect = (InsectWings)command.context;
            string path = EditorUtility.SaveFilePanel(k_Title, "", insect.name + ".insect", "json");
            if (string.IsNullOrEmpty(path))
                return;
            string whole = path.EndsWith(InsectFile.Ending, StringComparison.OrdinalIgnoreCase)
                ? path
                : Path.ChangeExtension(path, null) + InsectFile.Ending;
            string refusal = InsectExport.Write(insect, whole);
            if (refusal != null)
                EditorUtility.DisplayDialog(k_Title, refusal, "OK");
        }
    }
}
