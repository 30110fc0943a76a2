using UnityEngine;

namespace UnityEditor;

public class AssetImporter : Object
{
    public string assetPath { get; }
    public string userData { get; set; }

    public static AssetImporter GetAtPath(string path) => throw Absent.Editor;
    public void SaveAndReimport() => throw Absent.Editor;
}
