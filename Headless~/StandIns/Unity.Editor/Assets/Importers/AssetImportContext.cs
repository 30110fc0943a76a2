using System;
using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace UnityEditor.AssetImporters;

public class AssetImportContext
{
    private readonly Dictionary<string, Object> _objects = [];

    internal AssetImportContext(string path) => assetPath = path;

    public string assetPath { get; }
    public Object mainObject { get; private set; }

    internal IReadOnlyDictionary<string, Object> Objects => _objects;
    internal List<string> Errors { get; } = [];
    internal List<string> Warnings { get; } = [];
    internal List<string> Dependencies { get; } = [];

    public void AddObjectToAsset(string identifier, Object obj)
    {
        if (obj == null)
            throw new ArgumentNullException(nameof(obj));
        if (!_objects.TryAdd(identifier, obj))
            throw new InvalidOperationException($"Two objects of the asset have the identifier '{identifier}'.");
    }

    public void SetMainObject(Object obj)
    {
        if (!_objects.ContainsValue(obj))
            throw new InvalidOperationException("The main object must have been added to the asset.");
        mainObject = obj;
    }

    public void DependsOnSourceAsset(string path)
    {
        if (string.IsNullOrEmpty(path) || path == assetPath || System.IO.Path.IsPathRooted(path))
            throw new ArgumentException($"An asset cannot depend on '{path}'.", nameof(path));
        Dependencies.Add(path);
    }

    public void LogImportError(string msg, Object obj = null) => Errors.Add(msg);
    public void LogImportWarning(string msg, Object obj = null) => Warnings.Add(msg);
}
