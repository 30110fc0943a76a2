namespace UnityEngine;

/// <summary>There is no screen: drawing is checked and forgotten.</summary>
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
