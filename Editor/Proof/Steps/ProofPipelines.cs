using System;
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Proof
{
    /// <summary>Render pipelines of a proof: the packages that they need, and their settings in a project.</summary>
    internal static class ProofPipelines
    {
        public const string BuiltIn = "builtin", Universal = "urp", HighDefinition = "hdrp";

        private const string k_Asset = "Assets/Proof Pipeline.asset";

        /// <summary>All that a proof knows.</summary>
        public static readonly string[] All = { BuiltIn, Universal, HighDefinition };

        /// <summary>Package that a pipeline needs; null for the built-in one.</summary>
        public static string PackageOf(string pipeline) => pipeline switch
        {
            BuiltIn => null,
            Universal => "com.unity.render-pipelines.universal",
            HighDefinition => "com.unity.render-pipelines.high-definition",
            _ => throw new ArgumentException($"'{pipeline}' is no render pipeline; allowed are {string.Join(", ", All)}."),
        };

        /// <summary>Version of a package that comes with an editor; null where it has none.</summary>
        /// <param name="contents">Folder of the editor's data, EditorApplication.applicationContentsPath.</param>
        /// <param name="package">Name of the package.</param>
        public static string VersionIn(string contents, string package) =>
            PackageFile.VersionIn(Path.Combine(contents, "Resources", "PackageManager", "BuiltInPackages", package));

        /// <summary>Makes a pipeline's asset and sets it for this project.</summary>
        /// <returns>What was set, and whether it is the one that is asked for.</returns>
        public static ProofLine Set(string pipeline)
        {
            const string claim = "the render pipeline is set";
            if (pipeline != BuiltIn)
            {
                Object asset = Create(pipeline);
                if (asset == null)
                    return ProofLine.Of(claim, false, "no asset", pipeline, "the package has no type of the known name");
                AssetDatabase.CreateAsset(asset, k_Asset);
                GraphicsSettings.defaultRenderPipeline = (RenderPipelineAsset)asset;
                AssetDatabase.SaveAssets();
            }

            RenderPipelineAsset set = GraphicsSettings.defaultRenderPipeline;
            return ProofLine.Of(claim, set == null == (pipeline == BuiltIn), set == null ? "built-in" : set.GetType().Name, pipeline);
        }

        // By their names: the package does not refer to any of the pipelines.
        private static Object Create(string pipeline)
        {
            if (pipeline == HighDefinition)
                return ScriptableObject.CreateInstance("HDRenderPipelineAsset");
            const string name = "UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset, Unity.RenderPipelines.Universal.Runtime";
            var asset = (Object)Type.GetType(name)?.GetMethod("Create")?.Invoke(null, new object[] { null });
            if (asset != null)
                SaveRenderer(asset);
            return asset;
        }

        // The list of renderers is saved only with renderers that are assets themselves.
        private static void SaveRenderer(Object asset)
        {
            SerializedProperty renderers = new SerializedObject(asset).FindProperty("m_RendererDataList");
            for (int k = 0; renderers != null && k < renderers.arraySize; k++)
            {
                Object renderer = renderers.GetArrayElementAtIndex(k).objectReferenceValue;
                if (renderer != null && !AssetDatabase.Contains(renderer))
                    AssetDatabase.CreateAsset(renderer, $"Assets/Proof Renderer {k}.asset");
            }
        }
    }
}
