using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Reads and writes properties of materials whose shader may not have them: Unity logs an error for each access to one that is missing.
    /// </summary>
    internal static class MaterialProperties
    {
        // The newest name first: some shaders keep the older ones, hidden, for materials that are converted.
        private static readonly string[] s_Textures = { "_BaseMap", "_BaseColorMap", "_MainTex" };
        private static readonly string[] s_Colours = { "_BaseColor", "_Color" };

        /// <summary>Sets a number where the shader has it.</summary>
        public static void SetFloatIfPresent(this Material material, string name, float value)
        {
            if (material.HasProperty(name))
                material.SetFloat(name, value);
        }

        /// <summary>Sets a vector where the shader has it.</summary>
        public static void SetVectorIfPresent(this Material material, string name, Vector4 value)
        {
            if (material.HasProperty(name))
                material.SetVector(name, value);
        }

        /// <summary>Sets a colour where the shader has it.</summary>
        public static void SetColourIfPresent(this Material material, string name, Color value)
        {
            if (material.HasProperty(name))
                material.SetColor(name, value);
        }

        /// <summary>Returns the texture of the surface; null where there is none.</summary>
        public static Texture SurfaceTexture(this Material material)
        {
            string name = FirstPresent(material, s_Textures);
            return name == null ? null : material.GetTexture(name);
        }

        /// <summary>Sets the texture of the surface where the shader has one.</summary>
        public static void SetSurfaceTexture(this Material material, Texture texture)
        {
            string name = FirstPresent(material, s_Textures);
            if (name != null)
                material.SetTexture(name, texture);
        }

        /// <summary>Sets the colour of the surface where the shader has one.</summary>
        public static void SetSurfaceColour(this Material material, Color colour)
        {
            string name = FirstPresent(material, s_Colours);
            if (name != null)
                material.SetColor(name, colour);
        }

        private static string FirstPresent(Material material, string[] names)
        {
            foreach (string name in names)
            {
                if (material.HasProperty(name))
                    return name;
            }

            return null;
        }
    }
}
