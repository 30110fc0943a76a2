using System;
using StandIns;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class AssetDatabase
{
    public static void CreateAsset(Object asset, string path) => ProjectAssets.Add(path, asset);
    public static string GenerateUniqueAssetPath(string path) => ProjectAssets.FreePath(path);
    public static void SaveAssets() => EditorUtility.ForgetChanges(null);
    public static void SaveAssetIfDirty(Object obj) => EditorUtility.ForgetChanges(obj);

    public static void Refresh() => throw Absent.Editor;
    public static string GetAssetPath(Object assetObject) => ProjectAssets.PathOf(assetObject);
    public static Object LoadAssetAtPath(string assetPath, Type type) => throw Absent.Editor;
    public static T LoadAssetAtPath<T>(string assetPath) where T : Object => ProjectAssets.Load(assetPath) as T;
    public static Object LoadMainAssetAtPath(string assetPath) => throw Absent.Editor;
    public static Object[] LoadAllAssetsAtPath(string assetPath) => throw Absent.Editor;
    public static void AddObjectToAsset(Object objectToAdd, string path) => ProjectAssets.AddTo(path, objectToAdd);
    public static void AddObjectToAsset(Object objectToAdd, Object assetObject) => throw Absent.Editor;
    public static bool Contains(Object obj) => ProjectAssets.PathOf(obj).Length > 0;
    public static bool IsMainAsset(Object obj) => throw Absent.Editor;
    public static bool IsSubAsset(Object obj) => throw Absent.Editor;
    public static bool DeleteAsset(string path) => ProjectAssets.Delete(path);
    public static void ImportAsset(string path) => ProjectAssets.Import(path);
    public static void ImportAsset(string path, ImportAssetOptions options) => throw Absent.Editor;
    /// <summary>The asset alone: nothing here is known to depend on others.</summary>
    public static string[] GetDependencies(string pathName) => [pathName];

    public static string[] FindAssets(string filter) => throw Absent.Editor;
    public static string[] FindAssets(string filter, string[] searchInFolders) => throw Absent.Editor;
    /// <summary>Gives no GUID.</summary>
    public static string CreateFolder(string parentFolder, string newFolderName)
    {
        ProjectAssets.AddFolder(parentFolder, newFolderName);
        return "";
    }

    public static bool IsValidFolder(string path) => ProjectAssets.IsFolder(path);
    public static string GUIDToAssetPath(string guid) => throw Absent.Editor;
    public static string AssetPathToGUID(string path) => throw Absent.Editor;
    public static void StartAssetEditing() => throw Absent.Editor;
    public static void StopAssetEditing() => throw Absent.Editor;
    public static bool IsOpenForEdit(string assetOrMetaFilePath) => ProjectAssets.CanWrite(assetOrMetaFilePath);

    /// <summary>Returns the answer for the object's path.</summary>
    public static bool IsOpenForEdit(Object assetObject) => IsOpenForEdit(GetAssetPath(assetObject));

    public static string MoveAsset(string oldPath, string newPath) => throw Absent.Editor;
    public static bool CopyAsset(string path, string newPath) => throw Absent.Editor;
    public static string RenameAsset(string pathName, string newName) => throw Absent.Editor;
}
