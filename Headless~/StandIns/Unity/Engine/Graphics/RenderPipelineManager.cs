using System;

namespace UnityEngine.Rendering;

/// <summary>Pipeline of scripts; none is ever active here, but a test may draw as one does.</summary>
public static class RenderPipelineManager
{
    public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;

    internal static void Begin(Camera camera) => beginCameraRendering?.Invoke(default, camera);
}

public struct ScriptableRenderContext
{
}
