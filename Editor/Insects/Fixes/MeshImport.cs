using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Turns on Read/Write in the import settings of meshes.</summary>
    internal static class MeshImport
    {
        /// <summary>Reason why a mesh that cannot be read cannot be made readable from here either; null when it can.</summary>
        public static string FindObstacle(Mesh mesh)
        {
            string path = AssetDatabase.GetAssetPath(mesh);
            if (string.IsNullOrEmpty(path))
            {
                return $"Mesh '{mesh.name}' was made by a script, which threw its readable copy away. Have it call "
                    + "UploadMeshData(false), or none.";
            }
            if (!(AssetImporter.GetAtPath(path) is ModelImporter))
            {
                return $"Mesh '{mesh.name}' is saved in '{path}', which has no import settings. Make the asset again from a readable mesh, "
                    + "or set m_IsReadable to 1 in it with a text editor.";
            }
            return AssetDatabase.IsOpenForEdit(path)
                ? null
                : $"'{path}' cannot be changed: it is in a read-only package, or locked by version control. Copy the model into the Assets "
                    + "folder and use that.";
        }

        /// <summary>Imports the models of some meshes again, each once, so that scripts can read them.</summary>
        /// <param name="meshes">None has an obstacle.</param>
        /// <param name="undoName">Name in the undo menu.</param>
        public static void MakeReadable(IEnumerable<Mesh> meshes, string undoName)
        {
            var models = new HashSet<string>();
            foreach (Mesh mesh in meshes)
                models.Add(AssetDatabase.GetAssetPath(mesh));
            foreach (string path in models)
            {
                var importer = (ModelImporter)AssetImporter.GetAtPath(path);
                Undo.RegisterImporterUndo(path, undoName);
                importer.isReadable = true;
                importer.SaveAndReimport();
            }
        }
    }
}
