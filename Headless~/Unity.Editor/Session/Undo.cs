using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Does what it is asked to do and records nothing.</summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    public static void RecordObject(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static void RecordObjects(Object[] objectsToUndo, string name) => ArgumentNullException.ThrowIfNull(objectsToUndo);

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static void RegisterFullObjectHierarchyUndo(Object objectToUndo, string name) => ArgumentNullException.ThrowIfNull(objectToUndo);

    public static Component AddComponent(GameObject gameObject, Type type) => gameObject.AddComponent(type);

    public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();

    public static void DestroyObjectImmediate(Object objectToUndo) => Object.DestroyImmediate(objectToUndo);

    public static void SetTransformParent(Transform transform, Transform newParent, string name) => transform.SetParent(newParent);

    public static int GetCurrentGroup() => 0;

    public static void IncrementCurrentGroup()
    {
    }

    public static void SetCurrentGroupName(string name)
    {
    }

    public static void CollapseUndoOperations(int groupIndex)
    {
    }
}
