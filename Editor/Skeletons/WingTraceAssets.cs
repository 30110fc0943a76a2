using Alate.Authoring;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Saves a traced wing as a mesh and a skeleton beside its picture.</summary>
    internal static class WingTraceAssets
    {
        private const string k_Assets = "Assets";

        /// <summary>Saves both under names of their own and returns the skeleton.</summary>
        /// <param name="trace">Its skeleton becomes the asset.</param>
        /// <param name="imagePath">Asset path of the picture; empty when it is no asset.</param>
        /// <param name="name">What the assets are called.</param>
        public static WingSkeleton Save(WingTrace trace, string imagePath, string name)
        {
            string folder = FolderFor(imagePath);
            var mesh = trace.Surface.ToMesh(name);
            mesh.RecalculateTangents();
            trace.Skeleton.name = name + " Skeleton";
            AssetDatabase.CreateAsset(mesh, AssetDatabase.GenerateUniqueAssetPath($"{folder}/{name}.asset"));
            AssetDatabase.CreateAsset(trace.Skeleton, AssetDatabase.GenerateUniqueAssetPath($"{folder}/{name} Skeleton.asset"));
            AssetDatabase.SaveAssets();
            return trace.Skeleton;
        }

        /// <summary>Folder of the picture; the project's top one where that is not the user's, as a package's is.</summary>
        public static string FolderFor(string imagePath)
        {
            if (string.IsNullOrEmpty(imagePath))
                return k_Assets;
            string path = imagePath.Replace('\\', '/');
            int end = path.LastIndexOf('/');
            return end > 0 && path.StartsWith(k_Assets + "/", System.StringComparison.Ordinal) ? path.Substring(0, end) : k_Assets;
        }
    }
}
