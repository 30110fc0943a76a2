using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace StandIns;

/// <summary>The assets of a project that exists in memory only.</summary>
[Unity.StandIns.StandInExtension]
public static class ProjectAssets
{
    private static readonly Dictionary<string, Object> s_Assets = [];
    private static readonly Dictionary<Object, string> s_Parts = [];
    private static readonly Dictionary<string, AssetImporter> s_Importers = [];
    private static readonly HashSet<string> s_Folders = [];

    /// <summary>A model file with one mesh; those below Packages cannot be changed.</summary>
    public static void AddModel(string path, Mesh mesh)
    {
        s_Assets[path] = mesh;
        s_Importers[path] = new ModelImporter { assetPath = path, isReadable = mesh.isReadable };
    }

    /// <summary>An asset of a package; nobody can change it.</summary>
    public static void AddToPackage(string path, Object asset) => s_Assets[path] = asset;

    /// <summary>Forgets all assets, and destroys none.</summary>
    public static void Clear()
    {
        s_Assets.Clear();
        s_Parts.Clear();
        s_Importers.Clear();
        s_Folders.Clear();
        ProjectFiles.Clear();
    }

    /// <summary>An asset with all that an importer made of its file.</summary>
    internal static void AddImported(AssetImporter importer, Object main, IEnumerable<Object> objects)
    {
        s_Importers[importer.assetPath] = importer;
        if (main != null)
            s_Assets[importer.assetPath] = main;
        foreach (Object part in objects)
        {
            if (part != main)
                s_Parts.Add(part, importer.assetPath);
        }
    }

    /// <summary>Forgets such an asset.</summary>
    internal static void RemoveImported(string path, IEnumerable<Object> objects)
    {
        s_Importers.Remove(path);
        s_Assets.Remove(path);
        foreach (Object part in objects)
            s_Parts.Remove(part);
    }

    internal static bool CanWrite(string path) => path.StartsWith("Assets/", StringComparison.Ordinal);

    internal static Object Load(string path) => s_Assets.GetValueOrDefault(path);

    internal static AssetImporter ImporterOf(string path) => s_Importers.GetValueOrDefault(path);

    internal static void Add(string path, Object asset)
    {
        if (asset == null)
            throw new ArgumentNullException(nameof(asset));
        if (!CanWrite(path) || Path.GetExtension(path).Length == 0 || !IsFolder(FolderOf(path)))
            throw new UnityException($"Creating asset at path {path} failed.");
        if (PathOf(asset).Length > 0)
            throw new UnityException($"'{asset.name}' is an asset already.");
        asset.name = Path.GetFileNameWithoutExtension(path);
        s_Assets[path] = asset;
    }

    /// <summary>Keeps a copy of an object in the scene.</summary>
    internal static GameObject AddPrefab(string path, GameObject root)
    {
        if (Path.GetExtension(path) != ".prefab")
            throw new ArgumentException($"'{path}' does not end in .prefab.", nameof(path));
        GameObject prefab = Object.Instantiate(root);
        Add(path, prefab);
        return prefab;
    }

    internal static bool IsFolder(string path) => path == "Assets" || s_Folders.Contains(path);

    internal static void AddFolder(string parent, string name)
    {
        if (!IsFolder(parent) || name.Contains('/'))
            throw new UnityException($"Folder '{name}' cannot be made in '{parent}'.");
        s_Folders.Add($"{parent}/{name}");
    }

    /// <summary>Takes a PNG picture in from its file.</summary>
    internal static void Import(string path)
    {
        var picture = new Texture2D(2, 2);
        if (!IsFolder(FolderOf(path)) || !picture.LoadImage(File.ReadAllBytes(ProjectFiles.Of(path)), true))
            throw new UnityException($"Importing {path} failed.");
        Add(path, picture);
        s_Importers[path] = new TextureImporter { assetPath = path };
    }

    internal static void AddTo(string path, Object part)
    {
        if (!s_Assets.ContainsKey(path))
            throw new UnityException($"There is no asset at {path} to add '{part.name}' to.");
        s_Parts.Add(part, path);
    }

    internal static bool Delete(string path)
    {
        if (s_Folders.Remove(path))
            return DeleteBelow(path + "/");
        if (!s_Assets.Remove(path, out Object asset))
            return false;
        Object.DestroyImmediate(asset, true);
        return true;
    }

    internal static string PathOf(Object asset)
    {
        foreach ((string path, Object known) in s_Assets)
        {
            if (ReferenceEquals(known, asset) && asset != null)
                return path;
        }

        return asset != null && s_Parts.TryGetValue(asset, out string whole) ? whole : "";
    }

    internal static string FreePath(string path)
    {
        string free = path;
        for (int number = 1; s_Assets.ContainsKey(free) || s_Folders.Contains(free); number++)
            free = $"{path[..^Path.GetExtension(path).Length]} {number}{Path.GetExtension(path)}";
        return free;
    }

    internal static void Reimport(AssetImporter importer)
    {
        if (!CanWrite(importer.assetPath))
            throw new UnityException($"'{importer.assetPath}' is in a read-only package.");
        if (importer is ModelImporter model && s_Assets[importer.assetPath] is Mesh mesh)
            mesh.SetReadable(model.isReadable);
        if (importer is TextureImporter texture)
            ((Texture2D)s_Assets[importer.assetPath]).wrapMode = texture.wrapMode;
    }

    private static bool DeleteBelow(string folder)
    {
        s_Folders.RemoveWhere(path => path.StartsWith(folder, StringComparison.Ordinal));
        foreach (string path in s_Assets.Keys.Where(path => path.StartsWith(folder, StringComparison.Ordinal)).ToArray())
            Delete(path);
        return true;
    }

    private static string FolderOf(string path) => path[..path.LastIndexOf('/')];
}
