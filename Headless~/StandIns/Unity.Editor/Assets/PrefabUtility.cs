using StandIns;
using UnityEngine;

namespace UnityEditor;

public sealed class PrefabUtility
{
    public static bool IsPartOfPrefabAsset(Object componentOrGameObject) => throw Absent.Editor;
    public static bool IsPartOfPrefabInstance(Object componentOrGameObject) => PrefabInstances.Contains(componentOrGameObject);
    public static bool IsPartOfAnyPrefab(Object componentOrGameObject) => throw Absent.Editor;
    public static bool IsPartOfNonAssetPrefabInstance(Object componentOrGameObject) => throw Absent.Editor;
    public static void RecordPrefabInstancePropertyModifications(Object targetObject) => PrefabInstances.Record(targetObject);
    public static GameObject SaveAsPrefabAsset(GameObject instanceRoot, string assetPath) =>
        ProjectAssets.AddPrefab(assetPath, instanceRoot);
    public static GameObject SaveAsPrefabAsset(GameObject instanceRoot, string assetPath, out bool success) => throw Absent.Editor;
    public static GameObject SaveAsPrefabAssetAndConnect(
        GameObject instanceRoot,
        string assetPath,
        InteractionMode action) => throw Absent.Editor;
    public static Object InstantiatePrefab(Object assetComponentOrGameObject) =>
        PrefabInstances.Make((GameObject)assetComponentOrGameObject);
    public static T GetCorrespondingObjectFromSource<T>(T componentOrGameObject) where T : Object => throw Absent.Editor;
    public static string GetPrefabAssetPathOfNearestInstanceRoot(Object instanceComponentOrGameObject) => throw Absent.Editor;
    public static void UnpackPrefabInstance(
        GameObject instanceRoot,
        PrefabUnpackMode unpackMode,
        InteractionMode action) => throw Absent.Editor;
    public static GameObject LoadPrefabContents(string assetPath) => throw Absent.Editor;
    public static void UnloadPrefabContents(GameObject contentsRoot) => throw Absent.Editor;
}
