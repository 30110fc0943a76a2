using System;

namespace UnityEngine;

public sealed class Resources
{
    public static Object[] FindObjectsOfTypeAll(Type type) => [.. ObjectRegistry.Find<Object>(type)];

    public static T[] FindObjectsOfTypeAll<T>() where T : Object => [.. ObjectRegistry.Find<T>(typeof(T))];

    /// <summary>There are no asset folders here: always null.</summary>
    public static T Load<T>(string path) where T : Object => null;

    public static void UnloadAsset(Object assetToUnload) => Object.DestroyImmediate(assetToUnload, true);

}
