using System;
using Unity.StandIns;

namespace UnityEngine;

public sealed class Resources
{
    public static Object[] FindObjectsOfTypeAll(Type type) => [.. ObjectRegistry.Find<Object>(type)];

    public static T[] FindObjectsOfTypeAll<T>() where T : Object => [.. ObjectRegistry.Find<T>(typeof(T))];

    /// <summary>Returns null except for <see cref="ProjectShaders"/>: there are no asset folders.</summary>
    public static T Load<T>(string path) where T : Object => ProjectShaders.InResources(path) as T;

    public static void UnloadAsset(Object assetToUnload) => Object.DestroyImmediate(assetToUnload, true);

}
