using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Converts wings that bones move to plain renderers, saves their meshes as an asset and puts them into the list; the body stays
    /// skinned.
    /// </summary>
    internal sealed class SkinnedWingsFix : InsectFix
    {
        private readonly AskForPath m_Ask;

        /// <param name="ask">Where to save the new meshes.</param>
        public SkinnedWingsFix(AskForPath ask)
        {
            m_Ask = ask;
        }

        /// <inheritdoc/>
        public override string Label => "Convert Skinned Wings…";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Cuts the wings out of the skinned mesh and draws each by a MeshRenderer below the bone that carries it; the body "
            + "stays skinned. "
            + "The model is not changed: the new meshes are saved as an asset where you choose. Can be undone; the asset stays.";

        /// <inheritdoc/>
        public override string FindObstacle(InsectWings insect, in InsectProblem problem)
        {
            if (EditorUtility.IsPersistent(insect))
                return "Open the prefab, or put it into a scene, to convert its wings.";
            foreach (SkinnedMeshRenderer skinned in WingFinder.FindSkinned(insect.transform))
            {
                Mesh mesh = skinned.sharedMesh;
                string obstacle = mesh == null || mesh.isReadable ? null : MeshImport.FindObstacle(mesh);
                if (obstacle != null)
                    return obstacle;
            }

            return null;
        }

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            string obstacle = FindObstacle(insect, problem);
            if (obstacle != null)
                return FixOutcome.Refused(obstacle);
            List<SkinnedMeshRenderer> skinned = WingFinder.FindSkinned(insect.transform);
            if (skinned.Count == 0)
                return FixOutcome.Refused($"No SkinnedMeshRenderer below '{insect.name}' draws wings.");
            string path = m_Ask(
                "Save Wing Meshes", AssetPath.FileName(insect.name + " Wing Meshes"), "Choose where the meshes of the wings are saved.");
            if (string.IsNullOrEmpty(path))
                return FixOutcome.Refused("");
            obstacle = AssetPath.FindProblem(path);
            if (obstacle != null)
                return FixOutcome.Refused(obstacle);
            MeshImport.MakeReadable(skinned.ConvertAll(s => s.sharedMesh).FindAll(mesh => !mesh.isReadable), Label);
            return Convert(insect, skinned, path);
        }

        private FixOutcome Convert(InsectWings insect, List<SkinnedMeshRenderer> skinned, string path)
        {
            var made = new List<Object>();
            string problem = "";
            Edits.InOneStep(Label, () =>
            {
                foreach (SkinnedMeshRenderer source in skinned)
                {
                    try
                    {
                        made.AddRange(Convert(source, insect.transform));
                    }
                    catch (ArgumentException exception)
                    {
                        problem = RiggedParts.OneLine(exception);
                    }
                }

                if (made.Count > 0)
                    new FindWingsFix().Apply(insect, InsectProblem.None);
            });
            if (made.Count == 0)
                return FixOutcome.Refused(problem);
            Save(made, path);
            return FixOutcome.Done(problem);
        }

        private List<Object> Convert(SkinnedMeshRenderer source, Transform insect)
        {
            Undo.RecordObject(source, Label);
            foreach (LODGroup group in SkinnedWingConversion.DetailGroups(source))
                Undo.RecordObject(group, Label);
            SkinnedWingResult result = SkinnedWingConversion.Convert(source, insect);
            foreach (MeshRenderer wing in result.Wings)
                Undo.RegisterCreatedObjectUndo(wing.gameObject, Label);
            Edits.KeepOverrides(source);
            foreach (LODGroup group in SkinnedWingConversion.DetailGroups(source))
                Edits.KeepOverrides(group);
            var meshes = new List<Object>(result.WingMeshes);
            if (result.BodyMesh != null)
                meshes.Add(result.BodyMesh);
            return meshes;
        }

        private static void Save(List<Object> meshes, string path)
        {
            AssetDatabase.CreateAsset(meshes[0], path);
            for (int k = 1; k < meshes.Count; k++)
                AssetDatabase.AddObjectToAsset(meshes[k], path);
            AssetDatabase.SaveAssets();
        }
    }
}
