using StandIns;
using UnityEngine;

namespace UnityEditor;

public class AssetImporter : Object
{
    public string assetPath { get; internal set; }
    public string userData { get; set; }

    public static AssetImporter GetAtPath(string path) => ProjectAssets.ImporterOf(path);
    public void SaveAndReimport() => ProjectAssets.Reimport(this);
}
