namespace UnityEngine.Rendering;

/// <summary>The built-in render pipeline, always.</summary>
public sealed class GraphicsSettings : Object
{
    public static RenderPipelineAsset currentRenderPipeline => null;
    public static RenderPipelineAsset defaultRenderPipeline { get; set; }
}
