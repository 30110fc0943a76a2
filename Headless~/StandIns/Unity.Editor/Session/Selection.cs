using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class Selection
{
    private static Object[] s_Objects = [];

    public static Action selectionChanged;

    public static Object[] objects
    {
        get => s_Objects;
        set
        {
            s_Objects = value ?? [];
            selectionChanged?.Invoke();
        }
    }

    public static Object activeObject
    {
        get => s_Objects.Length == 0 ? null : s_Objects[0];
        set => objects = value == null ? [] : [value];
    }

    public static GameObject activeGameObject
    {
        get => activeObject as GameObject;
        set => activeObject = value;
    }

    public static Transform activeTransform
    {
        get => activeGameObject == null ? null : activeGameObject.transform;
        set => activeObject = value == null ? null : value.gameObject;
    }

    public static GameObject[] gameObjects => Array.FindAll(Array.ConvertAll(s_Objects, o => o as GameObject), o => o != null);
    public static Transform[] transforms => Array.ConvertAll(gameObjects, o => o.transform);

    public static bool Contains(Object obj) => Array.IndexOf(s_Objects, obj) >= 0;
    public static T[] GetFiltered<T>(SelectionMode mode) => throw Absent.Editor;
}
