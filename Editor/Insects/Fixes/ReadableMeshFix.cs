using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Turns on Read/Write in the import settings of all wing meshes that cannot be read; says what to do where there are no such settings.</summary>
    internal sealed class ReadableMeshFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Make Mesh Readable";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Turns on Read/Write in the import settings of the models that the wings of this insect come from, and imports them again.";

        /// <inheritdoc/>
        public override string FindObstacle(InsectWings insect, in InsectProblem problem)
        {
            string obstacle = null;
            foreach (Mesh mesh in UnreadableMeshes(insect))
            {
                obstacle = FindObstacle(mesh);
                if (obstacle == null)
                    return null;
            }

            return obstacle;
        }

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            var models = new HashSet<string>();
            string obstacle = "All meshes are readable.";
            foreach (Mesh mesh in UnreadableMeshes(insect))
            {
                string found = FindObstacle(mesh);
                if (found == null)
                    models.Add(AssetDatabase.GetAssetPath(mesh));
                else
                    obstacle = found;
            }

            if (models.Count == 0)
                return FixOutcome.Refused(obstacle);
            foreach (string path in models)
            {
                var importer = (ModelImporter)AssetImporter.GetAtPath(path);
                Undo.RegisterImporterUndo(path, Label);
                importer.isReadable = true;
                importer.SaveAndReimport();
            }

            return FixOutcome.Done();
        }

        /// <summary>Why a mesh cannot be made readable from here; null when it can.</summary>
        public static string FindObstacle(Mesh mesh)
        {
            string path = AssetDatabase.GetAssetPath(mesh);
            if (string.IsNullOrEmpty(path))
                return $"Mesh '{mesh.name}' was made by a script, which threw its readable copy away. Have it call UploadMeshData(false), or none.";
            if (!(AssetImporter.GetAtPath(path) is ModelImporter))
                return $"Mesh '{mesh.name}' is saved in '{path}', which has no import settings. Make the asset anew from a readable mesh, or set m_IsReadable to 1 in it with a text editor.";
            return AssetDatabase.IsOpenForEdit(path)
                ? null
                : $"'{path}' cannot be changed: it is in a read-only package, or locked by version control. Copy the model into the Assets folder and use that.";
        }

        private static IEnumerable<Mesh> UnreadableMeshes(InsectWings insect)
        {
            foreach (Wing wing in insect.Wings)
            {
                Mesh mesh = wing == null ? null : InsectCheck.MeshOf(wing, InsectCheck.FilterOf(wing));
                if (mesh != null && !mesh.isReadable)
                    yield return mesh;
            }
        }
    }
}
