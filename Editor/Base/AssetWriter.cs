using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Saves objects as assets. Overwrites an asset that exists at the path, so that all objects that refer to it get the new content.
    /// </summary>
    internal static class AssetWriter
    {
        /// <summary>Saves an object that is no asset yet.</summary>
        /// <param name="made">Becomes the asset, or is destroyed when its content has gone into the one that was there.</param>
        /// <param name="path">Has been checked by <see cref="AssetPath"/>.</param>
        /// <param name="undoName">Name in the undo menu.</param>
        /// <returns>The asset.</returns>
        public static T Save<T>(T made, string path, string undoName) where T : ScriptableObject
        {
            T existing = AssetDatabase.LoadAssetAtPath<T>(path);
            if (existing == null)
            {
                AssetDatabase.CreateAsset(made, path);
                AssetDatabase.SaveAssetIfDirty(made);
                return made;
            }

            made.name = existing.name;
            made.hideFlags = existing.hideFlags;
            Undo.RecordObject(existing, undoName);
            EditorUtility.CopySerialized(made, existing);
            EditorUtility.SetDirty(existing);
            AssetDatabase.SaveAssetIfDirty(existing);
            Object.DestroyImmediate(made);
            return existing;
        }
    }
}
