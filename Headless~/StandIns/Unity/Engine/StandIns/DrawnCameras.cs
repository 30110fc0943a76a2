using UnityEngine;
using UnityEngine.Rendering;

namespace Unity.StandIns;

/// <summary>Cameras that draw at the end of a frame, one after the other, as the engine tells scripts of them.</summary>
[StandInExtension]
public static class DrawnCameras
{
    /// <summary>True where they draw as those of a pipeline of scripts.</summary>
    public static bool ByAPipeline { get; set; }

    /// <summary>One camera draws, as by Camera.Render.</summary>
    public static void Draw(Camera camera)
    {
        if (ByAPipeline)
            RenderPipelineManager.Begin(camera);
        else
            Camera.onPreCull?.Invoke(camera);
    }

    internal static void DrawAll()
    {
        for (int k = 0; k < Camera.Living.Count; k++)
        {
            if (Camera.Living[k].IsUsed)
                Draw(Camera.Living[k]);
        }
    }
}
