using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor.AssetImporters;
using Object = UnityEngine.Object;

namespace StandIns;

/// <summary>Result of a scripted importer on a file of the project.</summary>
[Unity.StandIns.StandInExtension]
public sealed class ImportedAsset : IDisposable
{
    private readonly AssetImportContext _context;

    private ImportedAsset(AssetImportContext context) => _context = context;

    /// <summary>The object that the asset is.</summary>
    public Object Main => _context.mainObject;

    /// <summary>[identifier] All objects of the asset.</summary>
    public IReadOnlyDictionary<string, Object> Objects => _context.Objects;

    /// <summary>Errors of the import.</summary>
    public IReadOnlyList<string> Errors => _context.Errors;

    /// <summary>Warnings of the import.</summary>
    public IReadOnlyList<string> Warnings => _context.Warnings;

    /// <summary>Assets whose change imports this one again.</summary>
    public IReadOnlyList<string> Dependencies => _context.Dependencies;

    /// <summary>Writes a file of the project.</summary>
    public static void Write(string path, byte[] content) => File.WriteAllBytes(ProjectFiles.Of(path), content);

    /// <summary>Imports a file of the project.</summary>
    /// <param name="importer">With its settings.</param>
    /// <param name="path">Path of the asset.</param>
    public static ImportedAsset Of(ScriptedImporter importer, string path)
    {
        importer.assetPath = path;
        var context = new AssetImportContext(path);
        importer.OnImportAsset(context);
        ProjectAssets.AddImported(importer, context.mainObject, context.Objects.Values);
        return new ImportedAsset(context);
    }

    /// <summary>Destroys all objects.</summary>
    public void Dispose()
    {
        ProjectAssets.RemoveImported(_context.assetPath, Objects.Values);
        foreach (Object part in Objects.Values)
            Object.DestroyImmediate(part, true);
    }
}
