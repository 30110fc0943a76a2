using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Tells whether a renderer's materials read tangents. Shaders that are not known are taken to.</summary>
    internal static class MaterialTangents
    {
        // Shaders that read tangents with one of the keywords only.
        private static readonly string[] s_Shaders =
        {
            "Alate/Wing", "Standard", "Standard (Specular setup)", "Universal Render Pipeline/Lit", "Universal Render Pipeline/Complex Lit",
            "Universal Render Pipeline/Simple Lit", "Universal Render Pipeline/Baked Lit", "Universal Render Pipeline/Unlit",
        };

        private static readonly string[] s_Keywords = { "_NORMALMAP", "_PARALLAXMAP", "_DETAIL_MULX2", "_DETAIL_SCALED" };

        /// <summary>Returns true where a material may read tangents, or there is none yet.</summary>
        public static bool AreRead(Renderer renderer)
        {
            Material[] materials = renderer.sharedMaterials;
            return materials.Length == 0 || Array.Exists(materials, IsReader);
        }

        private static bool IsReader(Material material) =>
            material == null || Array.IndexOf(s_Shaders, material.shader.name) < 0 || Array.Exists(s_Keywords, material.IsKeywordEnabled);
    }
}
