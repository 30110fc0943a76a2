using System;
using System.Collections.Generic;
using System.IO;
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
    }

    internal static bool CanWrite(string path) => path.StartsWith("Assets/", StringComparison.Ordinal);

    internal static Object Load(string path) => s_Assets.GetValueOrDefault(path);

    internal static AssetImporter ImporterOf(string path) => s_Importers.GetValueOrDefault(path);

    internal static void Add(string path, Object asset)
    {
        if (asset == null)
            throw new ArgumentNullException(nameof(asset));
        if (!CanWrite(path) || Path.GetExtension(path).Length == 0)
            throw new UnityException($"Creating asset at path {path} failed.");
        if (PathOf(asset).Length > 0)
            throw new UnityException($"'{asset.name}' is an asset already.");
        asset.name = Path.GetFileNameWithoutExtension(path);
        s_Assets[path] = asset;
    }

    internal static void AddTo(string path, Object part)
    {
        if (!s_Assets.ContainsKey(path))
            throw new UnityException($"There is no asset at {path} to add '{part.name}' to.");
        s_Parts.Add(part, path);
    }

    internal static bool Delete(string path)
    {
        if (!s_Assets.Remove(path, out Object asset))
            return false;
        Object.DestroyImmediate(asset, true);
        return true;
    }

    internal static string PathOf(Object asset)
    {
        foreach (var (path, known) in s_Assets)
        {
            if (ReferenceEquals(known, asset) && asset != null)
                return path;
        }

        return asset != null && s_Parts.TryGetValue(asset, out string whole) ? whole : "";
    }

    internal static string FreePath(string path)
    {
        string free = path;
        for (int number = 1; s_Assets.ContainsKey(free); number++)
            free = $"{path[..^Path.GetExtension(path).Length]} {number}{Path.GetExtension(path)}";
        return free;
    }

    internal static void Reimport(AssetImporter importer)
    {
        if (!CanWrite(importer.assetPath))
            throw new UnityException($"'{importer.assetPath}' is in a read-only package.");
        if (importer is ModelImporter model && s_Assets[importer.assetPath] is Mesh mesh)
            mesh.SetReadable(model.isReadable);
    }
}
