namespace UnityEngine.Rendering;

/// <summary>The render pipeline of the project; the built-in one where there is no other. No quality level has one of its own.</summary>
public sealed class GraphicsSettings : Object
{
    public static RenderPipelineAsset currentRenderPipeline => defaultRenderPipeline;
    public static RenderPipelineAsset defaultRenderPipeline { get; set; }
}
