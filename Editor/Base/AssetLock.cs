using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Tells which assets keep no changes.</summary>
    internal static class AssetLock
    {
        /// <summary>
        /// Returns true for an asset of a read-only file, and for one that a scripted importer makes of its file: it is made again when the
        /// file changes, and what was edited is lost.
        /// </summary>
        public static bool IsLocked(Object asset) => AssetDatabase.Contains(asset)
            && (!AssetDatabase.IsOpenForEdit(asset) || AssetImporter.GetAtPath(AssetDatabase.GetAssetPath(asset)) is ScriptedImporter);
    }
}
