using System;

namespace UnityEngine;

/// <summary>A picture that nothing draws into: there is no graphics device.</summary>
public class RenderTexture : Texture
{
    internal RenderTexture()
    {
    }

    public static RenderTexture active { get; set; }

    public static RenderTexture GetTemporary(int width, int height, int depthBuffer) =>
        width > 0 && height > 0 ? new RenderTexture { width = width, height = height }
            : throw new ArgumentException("RenderTexture.GetTemporary: width and height must be greater than 0.");

    public static void ReleaseTemporary(RenderTexture temp) => DestroyImmediate(temp);
}
