using UnityEngine;

namespace Alate
{
    /// <summary>Copies the settings of a renderer, apart from its mesh and materials.</summary>
    internal static class RendererSettings
    {
        /// <summary>
        /// Layer, tag, shadows, probes, sorting, motion vectors and properties, as another renderer has them. Not the materials.
        /// </summary>
        public static void Copy(Renderer from, Renderer to)
        {
            to.gameObject.layer = from.gameObject.layer;
            to.gameObject.tag = from.gameObject.tag;
            to.enabled = from.enabled;
            to.forceRenderingOff = from.forceRenderingOff;
            to.shadowCastingMode = from.shadowCastingMode;
            to.receiveShadows = from.receiveShadows;
            to.lightProbeUsage = from.lightProbeUsage;
            to.lightProbeProxyVolumeOverride = from.lightProbeProxyVolumeOverride;
            to.reflectionProbeUsage = from.reflectionProbeUsage;
            to.probeAnchor = from.probeAnchor;
            to.motionVectorGenerationMode = from.motionVectorGenerationMode;
            to.allowOcclusionWhenDynamic = from.allowOcclusionWhenDynamic;
            to.renderingLayerMask = from.renderingLayerMask;
            to.rendererPriority = from.rendererPriority;
            to.sortingLayerID = from.sortingLayerID;
            to.sortingOrder = from.sortingOrder;
            if (!from.HasPropertyBlock())
                return;
            var properties = new MaterialPropertyBlock();
            from.GetPropertyBlock(properties);
            to.SetPropertyBlock(properties);
        }

        /// <summary>Copies the properties of one material of a renderer to a material of another.</summary>
        public static void CopyProperties(Renderer from, int material, Renderer to, int place)
        {
            if (!from.HasPropertyBlock())
                return;
            var properties = new MaterialPropertyBlock();
            from.GetPropertyBlock(properties, material);
            if (!properties.isEmpty)
                to.SetPropertyBlock(properties, place);
        }
    }
}
