using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Keeps states of objects in groups, and gives the last group back. What it was not told of stays changed.</summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    private const int k_Kept = 200;
    private static readonly List<UndoGroup> s_Done = [];
    private static readonly Stack<UndoGroup> s_Undone = [];
    private static int s_Group;
    private static string s_Name = "";

    public static void RecordObject(Object objectToUndo, string name)
    {
        ArgumentNullException.ThrowIfNull(objectToUndo);
        Current(name).Record(objectToUndo);
    }

    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        ArgumentNullException.ThrowIfNull(objectsToUndo);
        foreach (Object target in objectsToUndo)
            RecordObject(target, name);
    }

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name)
    {
        ArgumentNullException.ThrowIfNull(objectToUndo);
        Current(name).RecordMade(objectToUndo);
    }

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => RecordObject(objectToUndo, name);

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
        Current("Destroy").Destroyed = true;
        Object.DestroyImmediate(objectToUndo);
    }

    public static void SetTransformParent(Transform transform, Transform newParent, string name) => transform.SetParent(newParent);

    public static int GetCurrentGroup() => s_Group;

    public static string GetCurrentGroupName() => s_Name;

    public static void IncrementCurrentGroup()
    {
        s_Group++;
        s_Name = "";
    }

    public static void SetCurrentGroupName(string name)
    {
        s_Name = name;
        if (s_Done.Count > 0 && s_Done[^1].Number == s_Group)
            s_Done[^1].Name = name;
    }

    public static void CollapseUndoOperations(int groupIndex)
    {
        int first = s_Done.FindIndex(group => group.Number >= groupIndex);
        for (int i = s_Done.Count - 1; first >= 0 && i > first; i--)
        {
            s_Done[i - 1].Take(s_Done[i]);
            s_Done.RemoveAt(i);
        }
    }

    public static void PerformUndo()
    {
        if (s_Done.Count == 0)
            return;
        UndoGroup last = s_Done[^1];
        s_Done.RemoveAt(s_Done.Count - 1);
        s_Undone.Push(last.Revert());
        IncrementCurrentGroup();
        undoRedoPerformed?.Invoke();
    }

    public static void PerformRedo()
    {
        if (s_Undone.Count == 0)
            return;
        s_Done.Add(s_Undone.Pop().Revert());
        IncrementCurrentGroup();
        undoRedoPerformed?.Invoke();
    }

    public static void ClearAll()
    {
        s_Done.Clear();
        s_Undone.Clear();
    }

    private static UndoGroup Current(string name)
    {
        s_Undone.Clear();
        if (s_Name.Length == 0)
            s_Name = name;
        if (s_Done.Count == 0 || s_Done[^1].Number != s_Group)
            s_Done.Add(new UndoGroup(s_Group, s_Name));
        if (s_Done.Count > k_Kept)
            s_Done.RemoveAt(0);
        return s_Done[^1];
    }
}
