using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Catalogue
{
    /// <summary>
    /// Writes a look into the properties of each supported shader, by the names and keywords that the shader's own inspector sets.
    /// </summary>
    internal static class LookProperties
    {
        private const float k_Through = 0.5f, k_WingGloss = 0.06f, k_BodyGloss = 0.14f, k_Smoothness = 0.35f;

        /// <summary>Render queue of partly clear bodies: before the wings, which are blended over them.</summary>
        private const int k_ClearBodyQueue = (int)RenderQueue.Transparent - 1;

        public static void Write(Material material, in SurfaceLook look)
        {
            switch (material.shader.name)
            {
                case WingShaders.Own:
                    WriteOwn(material, look);
                    break;
                case WingShaders.HighDefinitionLit:
                    WriteHighDefinition(material, look);
                    break;
                case WingShaders.Standard:
                    WriteStandard(material, look);
                    break;
                default:
                    WriteUniversal(material, look);
                    break;
            }

            if (look.IsTranslucent)
            {
                material.SetOverrideTag("RenderType", "Transparent");
                material.renderQueue = look.IsThin ? (int)RenderQueue.Transparent : k_ClearBodyQueue;
            }

            if (look.IsCut)
            {
                material.SetOverrideTag("RenderType", "TransparentCutout");
                material.renderQueue = (int)RenderQueue.AlphaTest;
            }
        }

        private static void WriteOwn(Material material, in SurfaceLook look)
        {
            material.SetSurfaceTexture(look.Texture);
            material.SetColourIfPresent("_Underside", look.Underside);
            material.SetFloatIfPresent("_VertexColours", look.Texture == null ? 1f : 0f);
            material.SetFloatIfPresent("_Through", look.IsThin ? k_Through : 0f);
            material.SetFloatIfPresent("_Gloss", look.IsThin ? k_WingGloss : k_BodyGloss);
            material.SetFloatIfPresent("_Cull", (float)(look.IsThin ? CullMode.Off : CullMode.Back));
            material.SetFloatIfPresent("_Translucent", look.IsTranslucent ? 1f : 0f);
            material.SetFloatIfPresent("_Cut", look.IsCut ? 1f : 0f);
            material.SetFloatIfPresent("_AlphaToMask", look.IsCut ? 1f : 0f);
            EnableIf(look.IsCut, material, WingShaders.Cut);
            WriteBlend(material, look, BlendMode.One);
        }

        private static void WriteUniversal(Material material, in SurfaceLook look)
        {
            material.SetSurfaceTexture(look.Texture);
            material.SetSurfaceColour(Color.white);
            material.SetFloatIfPresent("_Smoothness", k_Smoothness);
            material.SetFloatIfPresent("_Cull", (float)(look.IsThin ? CullMode.Off : CullMode.Back));
            material.doubleSidedGI = look.IsThin;
            material.SetFloatIfPresent("_Surface", look.IsTranslucent ? 1f : 0f);
            material.SetFloatIfPresent("_AlphaClip", look.IsCut ? 1f : 0f);
            material.SetFloatIfPresent("_AlphaToMask", look.IsCut ? 1f : 0f);
            EnableIf(look.IsCut, material, "_ALPHATEST_ON");
            WriteBlend(material, look, BlendMode.SrcAlpha);
            EnableIf(look.IsTranslucent, material, "_SURFACE_TYPE_TRANSPARENT");
        }

        private static void WriteHighDefinition(Material material, in SurfaceLook look)
        {
            material.SetSurfaceTexture(look.Texture);
            material.SetSurfaceColour(Color.white);
            material.SetFloatIfPresent("_Smoothness", k_Smoothness);
            material.SetFloatIfPresent("_DoubleSidedEnable", look.IsThin ? 1f : 0f);
            material.SetFloatIfPresent("_CullMode", (float)(look.IsThin ? CullMode.Off : CullMode.Back));
            material.SetFloatIfPresent("_CullModeForward", (float)(look.IsThin ? CullMode.Off : CullMode.Back));

            // The normal of the far side is turned round.
            material.SetVectorIfPresent("_DoubleSidedConstants", new Vector4(-1f, -1f, -1f, 0f));
            material.doubleSidedGI = look.IsThin;
            EnableIf(look.IsThin, material, "_DOUBLESIDED_ON");
            material.SetFloatIfPresent("_SurfaceType", look.IsTranslucent ? 1f : 0f);
            material.SetFloatIfPresent(
                "_ZTestDepthEqualForOpaque", (float)(look.IsTranslucent ? CompareFunction.LessEqual : CompareFunction.Equal));
            material.SetFloatIfPresent("_AlphaCutoffEnable", look.IsCut ? 1f : 0f);
            EnableIf(look.IsCut, material, "_ALPHATEST_ON");
            material.SetFloatIfPresent("_TransparentZWrite", look.WritesDepth ? 1f : 0f);
            material.SetFloatIfPresent("_AlphaSrcBlend", (float)BlendMode.One);
            material.SetFloatIfPresent("_AlphaDstBlend", (float)(look.IsTranslucent ? BlendMode.OneMinusSrcAlpha : BlendMode.Zero));
            WriteBlend(material, look, BlendMode.One);
            EnableIf(look.IsTranslucent, material, "_SURFACE_TYPE_TRANSPARENT");
        }

        private static void WriteStandard(Material material, in SurfaceLook look)
        {
            const float cutout = 1f, fade = 2f;
            material.SetSurfaceTexture(look.Texture);
            material.SetFloatIfPresent("_Glossiness", k_Smoothness);
            material.SetFloatIfPresent("_Mode", look.IsTranslucent ? fade : look.IsCut ? cutout : 0f);
            WriteBlend(material, look, BlendMode.SrcAlpha);
            EnableIf(look.IsCut, material, "_ALPHATEST_ON");
            EnableIf(look.IsTranslucent, material, "_ALPHABLEND_ON");
        }

        private static void WriteBlend(Material material, in SurfaceLook look, BlendMode source)
        {
            material.SetFloatIfPresent("_SrcBlend", (float)(look.IsTranslucent ? source : BlendMode.One));
            material.SetFloatIfPresent("_DstBlend", (float)(look.IsTranslucent ? BlendMode.OneMinusSrcAlpha : BlendMode.Zero));
            material.SetFloatIfPresent("_ZWrite", look.WritesDepth ? 1f : 0f);
        }

        private static void EnableIf(bool isOn, Material material, string keyword)
        {
            if (isOn)
                material.EnableKeyword(keyword);
        }
    }
}
