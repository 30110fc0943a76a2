using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Crowds;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>One bake of an insect for crowds: what is asked for, what came of it, and its assets.</summary>
    internal sealed class InsectBaking : IDisposable
    {
        private const float k_Kilobyte = 1024f;

        private InsectBake m_Bake;

        /// <summary>Bake that was made and is not saved; null where there is none.</summary>
        public BakedInsect Made { get; private set; }

        /// <summary>Picture of what was made; null where nothing is.</summary>
        public LoopPreview Preview { get; private set; }

        /// <summary>Names of the clips that were made.</summary>
        public string[] Clips => m_Bake == null ? Array.Empty<string>() : m_Bake.Clips.Select(clip => clip.Name).ToArray();

        /// <summary>Reason why the insect cannot be baked, one line; null when all is well.</summary>
        public string Problem { get; private set; }

        /// <summary>Bakes an insect, and forgets what was baked before.</summary>
        /// <param name="insect">The insect.</param>
        /// <param name="clips">Names of motions.</param>
        /// <param name="frames">Frames of each loop.</param>
        /// <param name="proceeds">Asked with a clip's name and the share that is done; false stops, and nothing is made.</param>
        public void Bake(InsectWings insect, IEnumerable<string> clips, int frames, Func<string, float, bool> proceeds = null)
        {
            Dispose();
            try
            {
                m_Bake = InsectBaker.Bake(insect, clips.Select(BakeMotion.Find).ToList(), new BakeSettings(frames), proceeds);
                Made = BakedInsect.Create(m_Bake);
                Preview = new LoopPreview(m_Bake);
            }
            catch (BakeException problem)
            {
                Problem = problem.Message;
            }
            catch (OperationCanceledException)
            {
                Dispose();
            }
        }

        /// <summary>Size and errors of what was made, line by line.</summary>
        public IEnumerable<string> Describe()
        {
            if (Made == null)
                yield break;
            yield return Text($"Texture: {Made.Texture.width} x {Made.Texture.height} pixels, {Made.TextureBytes / k_Kilobyte:0} kB");
            foreach (BakedClip clip in m_Bake.Clips)
            {
                yield return Text(
                    $"{clip.Name}: {clip.Frames.Count} frames at {clip.Frequency:0.##} Hz; ")
                    + Text($"{100f * clip.Error.between:0.00} % of the wing length and ")
                    + Text($"{clip.Error.normalBetween:0.0}° of normals between frames");
            }

            foreach (CrowdSize size in Made.Sizes)
                yield return Text($"Mesh of {size.triangles} triangles: {100f * size.error:0.00} % of the wing length");
        }

        /// <summary>
        /// Saves what was made as one asset that holds its texture, meshes and materials; a path that is taken gets a number.
        /// </summary>
        /// <param name="path">Below Assets, ending in .asset.</param>
        /// <returns>The asset; null where the path cannot be used, see <see cref="Problem"/>.</returns>
        public BakedInsect Save(string path)
        {
            Problem = AssetPath.FindProblem(path);
            if (Problem != null || Made == null)
                return null;
            BakedInsect asset = Made;
            string free = AssetDatabase.GenerateUniqueAssetPath(path);
            AssetDatabase.CreateAsset(asset, free);
            AssetDatabase.AddObjectToAsset(asset.Texture, free);
            foreach (CrowdSize size in asset.Sizes)
                AssetDatabase.AddObjectToAsset(size.mesh, free);
            foreach (Material material in asset.Materials)
                AssetDatabase.AddObjectToAsset(material, free);
            EditorUtility.SetDirty(asset);
            AssetDatabase.SaveAssetIfDirty(asset);
            Made = null;
            Preview = null;
            return asset;
        }

        /// <summary>Saves a prefab beside an asset: a crowd of it with a spawner, ready to be dropped into a scene.</summary>
        /// <param name="asset">A saved asset.</param>
        /// <param name="live">Insect that takes the places of the nearest; an object of the scene is left out.</param>
        public GameObject SavePrefab(BakedInsect asset, InsectWings live)
        {
            var root = new GameObject(asset.name + " Crowd");
            try
            {
                InsectCrowd crowd = root.AddComponent<InsectCrowd>();
                crowd.Insect = asset;
                if (live != null && !string.IsNullOrEmpty(AssetDatabase.GetAssetPath(live)))
                    crowd.LivePrefab = live;
                root.AddComponent<CrowdSpawner>();
                return PrefabUtility.SaveAsPrefabAsset(root,
                    AssetDatabase.GenerateUniqueAssetPath(Path.ChangeExtension(AssetDatabase.GetAssetPath(asset), null) + " Crowd.prefab"));
            }
            finally
            {
                Object.DestroyImmediate(root);
            }
        }

        /// <summary>Destroys what was not saved.</summary>
        public void Dispose()
        {
            Problem = null;
            m_Bake = null;
            Preview = null;
            if (Made == null)
                return;
            Made.DestroyParts();
            Object.DestroyImmediate(Made);
            Made = null;
        }

        private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
