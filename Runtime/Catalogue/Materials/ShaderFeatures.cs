using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Warns in players when a material made at run time needs features of its shader that the build may not have: Unity leaves out the
    /// variants of URP/Lit, HDRP/Lit and Standard that no saved material uses. The package's own shader has none that could be left out.
    /// </summary>
    internal static class ShaderFeatures
    {
        private static readonly HashSet<string> s_Told = new HashSet<string>();

        /// <summary>Logs a warning, once for each shader and set of features.</summary>
        public static void Check(Material material)
        {
            if (Application.isEditor || material.shader.name == WingShaders.Own || material.shaderKeywords.Length == 0)
                return;
            string features = string.Join(", ", material.shaderKeywords);
            if (!s_Told.Add(material.shader.name + features))
                return;
            Debug.LogWarning(
                $"The material '{material.name}' was made at run time with the features "
                + $"{features} of {material.shader.name}. A build has them only where a saved material uses "
                + "them; without them wings are opaque, or are seen from one side. Make the insect in the editor with GameObject > Alate, "
                + "which saves its materials, or keep a "
                + "material with these features in a scene or in a Resources folder.", material);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Told.Clear();
    }
}
