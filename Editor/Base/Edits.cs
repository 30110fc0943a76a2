using System;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Changes objects so that the change can be undone, is saved, and counts as an override on instances of prefabs.</summary>
    internal static class Edits
    {
        /// <summary>Changes one object.</summary>
        /// <param name="target">What is about to be changed.</param>
        /// <param name="undoName">Name in the undo menu.</param>
        /// <param name="change">Changes nothing but the target.</param>
        public static void Change<T>(T target, string undoName, Action<T> change) where T : Object
        {
            Undo.RecordObject(target, undoName);
            change(target);
            KeepOverrides(target);
        }

        /// <summary>Records the changes to an instance of a prefab as overrides.</summary>
        public static void KeepOverrides(Object changed)
        {
            if (PrefabUtility.IsPartOfPrefabInstance(changed))
                PrefabUtility.RecordPrefabInstancePropertyModifications(changed);
        }

        /// <summary>Makes one step for undo of several changes.</summary>
        public static void InOneStep(string undoName, Action changes)
        {
            Undo.IncrementCurrentGroup();
            Undo.SetCurrentGroupName(undoName);
            int group = Undo.GetCurrentGroup();
            changes();
            Undo.CollapseUndoOperations(group);
        }
    }
}
