using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public static class ObjectFactory
{
    /// <summary>Below the parent like any child, or where it is; it gets a name of its own among its siblings and is selected.</summary>
    public static void PlaceGameObject(GameObject go, GameObject parent = null)
    {
        ArgumentNullException.ThrowIfNull(go);
        GameObjectUtility.SetParentAndAlign(go, parent);
        GameObjectUtility.EnsureUniqueNameForSibling(go);
        Undo.SetCurrentGroupName("Create " + go.name);
        Selection.activeGameObject = go;
    }

    public static GameObject CreateGameObject(string name, params Type[] types) => throw Absent.Editor;
    public static Component AddComponent(GameObject gameObject, Type type) => throw Absent.Editor;
    public static T AddComponent<T>(GameObject gameObject) where T : Component => throw Absent.Editor;
    public static Object CreateInstance(Type type) => throw Absent.Editor;
    public static T CreateInstance<T>() where T : Object => throw Absent.Editor;
}
