using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// Records and brings back what objects save. Making, destroying and moving objects is done, but not recorded. A frame is what lies between two
/// groups.
/// </summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    private static readonly UndoHistory s_History = new();

    public static void RecordObject(Object objectToUndo, string name) => s_History.Record(objectToUndo, name, always: false);

    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        foreach (Object target in objectsToUndo)
            RecordObject(target, name);
    }

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => s_History.Record(objectToUndo, name, always: true);

    public static void RegisterFullObjectHierarchyUndo(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static Component AddComponent(GameObject gameObject, Type type) => gameObject.AddComponent(type);

    public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();

    public static void DestroyObjectImmediate(Object objectToUndo) => Object.DestroyImmediate(objectToUndo);

    public static void SetTransformParent(Transform transform, Transform newParent, string name) => transform.SetParent(newParent);

    public static int GetCurrentGroup() => s_History.CurrentGroup;

    public static string GetCurrentGroupName() => s_History.CurrentGroupName;

    public static void IncrementCurrentGroup() => s_History.Increment();

    public static void SetCurrentGroupName(string name) => s_History.CurrentGroupName = name;

    public static void CollapseUndoOperations(int groupIndex) => s_History.Collapse(groupIndex);

    public static void RevertAllDownToGroup(int group) => s_History.Revert(group);

    public static void ClearAll() => s_History.Clear();

    public static void PerformUndo()
    {
        if (s_History.Undo())
            undoRedoPerformed?.Invoke();
    }

    public static void PerformRedo()
    {
        if (s_History.Redo())
            undoRedoPerformed?.Invoke();
    }
}
