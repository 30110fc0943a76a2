using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// Records and brings back what objects save, and takes away what was made. Moving objects is done, but not recorded; what was destroyed
/// does not come back. A frame is what lies between two groups.
/// </summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    private static readonly UndoHistory s_History = new();

    public static void RecordObject(Object objectToUndo, string name) => s_History.Record(objectToUndo, name, always: false);

    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        ArgumentNullException.ThrowIfNull(objectsToUndo);
        foreach (Object target in objectsToUndo)
            RecordObject(target, name);
    }

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name)
    {
        ArgumentNullException.ThrowIfNull(objectToUndo);
        s_History.Add(new MadeStep(objectToUndo), name);
    }

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => s_History.Record(objectToUndo, name, always: true);

    public static void RegisterFullObjectHierarchyUndo(Object objectToUndo, string name) => RecordObject(objectToUndo, name);

    /// <summary>Import settings do not come back here.</summary>
    public static void RegisterImporterUndo(string path, string name) => ArgumentNullException.ThrowIfNull(path);

    public static Component AddComponent(GameObject gameObject, Type type)
    {
        Component made = gameObject.AddComponent(type);
        RegisterCreatedObjectUndo(made, "Add Component");
        return made;
    }

    public static T AddComponent<T>(GameObject gameObject) where T : Component => (T)AddComponent(gameObject, typeof(T));

    public static void DestroyObjectImmediate(Object objectToUndo)
    {
        s_History.Add(new DestroyedStep(), "Destroy");
        Object.DestroyImmediate(objectToUndo);
    }

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
