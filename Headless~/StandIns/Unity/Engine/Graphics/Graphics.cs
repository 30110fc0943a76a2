namespace UnityEngine;

/// <summary>Checks calls of drawing and draws nothing: there is no screen.</summary>
public class Graphics
{
    public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix)
    {
        if (mesh == null)
            throw new System.ArgumentNullException(nameof(mesh));
    }
}

public sealed class GL
{
    public static bool wireframe { get; set; }
}
