using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public static class ObjectFactory
{
    public static GameObject CreateGameObject(string name, params Type[] types) => throw Absent.Editor;
    public static Component AddComponent(GameObject gameObject, Type type) => throw Absent.Editor;
    public static T AddComponent<T>(GameObject gameObject) where T : Component => throw Absent.Editor;
    public static Object CreateInstance(Type type) => throw Absent.Editor;
    public static T CreateInstance<T>() where T : Object => throw Absent.Editor;
}
