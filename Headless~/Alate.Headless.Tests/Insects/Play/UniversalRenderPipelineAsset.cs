using UnityEngine.Rendering;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Asset that is taken for that of URP, by its name.</summary>
    internal sealed class UniversalRenderPipelineAsset : RenderPipelineAsset
    {
    }
}
