using System;
using System.IO;
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
            if (string.IsNullOrEmpty(path))
                return;
            string refusal = Try(() =>
            {
                var skeleton = (WingSkeleton)command.context;
                var editing = new SkeletonEditing(JointSelection.Of(skeleton), new EditorUndo()) { Lock = SkeletonSessions.LockOf(skeleton) };
                editing.Start(out EditStart start);
                return editing.Commit("Import Skeleton", start, ImportAct.Make(File.ReadAllText(path))).Message;
            });
            Tell(refusal);
        }

        [MenuItem(k_Export)]
        private static void Export(MenuCommand command)
        {
            var skeleton = (WingSkeleton)command.context;
            string path = EditorUtility.SaveFilePanel(k_Title, "", skeleton.name, "json");
            if (string.IsNullOrEmpty(path))
                return;
            string refusal = Try(() =>
            {
                File.WriteAllText(path, SkeletonJson.Write(skeleton));
                return null;
            });
            Tell(refusal);
        }

        private static string Try(Func<string> act)
        {
            try
            {
                return act();
            }
            catch (Exception failed) when (failed is IOException || failed is UnauthorizedAccessException || failed is ArgumentException)
            {
                return failed.Message;
            }
        }

        private static void Tell(string refusal)
        {
            if (refusal != null)
                EditorUtility.DisplayDialog(k_Title, refusal, "OK");
        }
    }
}
