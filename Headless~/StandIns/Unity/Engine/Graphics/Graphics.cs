using Unity.Collections;
using Unity.StandIns;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Checks calls of drawing and draws nothing: there is no screen.</summary>
public class Graphics
{
    public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix)
    {
        if (mesh == null)
            throw new System.ArgumentNullException(nameof(mesh));
        DrawnMeshes.Note(mesh, matrix);
    }

    public static void RenderMesh(
        in RenderParams rparams, Mesh mesh, int submeshIndex, Matrix4x4 objectToWorld, Matrix4x4? prevObjectToWorld = null)
    {
        if (mesh == null)
            throw new System.ArgumentNullException(nameof(mesh));
        if (rparams.material == null)
            throw new System.ArgumentNullException(nameof(rparams), "There is no material.");
        if (submeshIndex < 0 || submeshIndex >= mesh.subMeshCount)
            throw new System.IndexOutOfRangeException("submeshIndex out of range");
        DrawnInstances.Note(rparams, mesh, submeshIndex, objectToWorld);
    }

    public static void RenderMeshInstanced<T>(
        RenderParams rparams, Mesh mesh, int submeshIndex, NativeArray<T> instanceData, int instanceCount = -1, int startInstance = 0)
            where T : unmanaged
    {
        if (mesh == null)
            throw new System.ArgumentNullException(nameof(mesh));
        if (rparams.material == null)
            throw new System.ArgumentNullException(nameof(rparams), "There is no material.");
        if (!rparams.material.enableInstancing)
            throw new System.InvalidOperationException("Material needs to enable instancing for use with RenderMeshInstanced.");
        if (submeshIndex < 0 || submeshIndex >= mesh.subMeshCount)
            throw new System.IndexOutOfRangeException("submeshIndex out of range");
        int count = instanceCount < 0 ? instanceData.Length - startInstance : instanceCount;
        if (startInstance < 0 || startInstance + count > instanceData.Length)
            throw new System.ArgumentOutOfRangeException(nameof(startInstance));
        if (count > 1023)
            throw new System.ArgumentOutOfRangeException(nameof(instanceCount), "At most 1023 instances are drawn by one call.");
        DrawnInstances.Note(rparams, mesh, submeshIndex, instanceData, count, startInstance);
    }
}

public struct RenderParams
{
    public RenderParams(Material mat)
    {
        material = mat;
        layer = 0;
        worldBounds = default;
        matProps = null;
        shadowCastingMode = ShadowCastingMode.Off;
        receiveShadows = false;
        camera = null;
        renderingLayerMask = 1;
        motionVectorMode = MotionVectorGenerationMode.Camera;
    }

    public Material material { get; set; }
    public int layer { get; set; }
    public Bounds worldBounds { get; set; }
    public MaterialPropertyBlock matProps { get; set; }
    public ShadowCastingMode shadowCastingMode { get; set; }
    public bool receiveShadows { get; set; }

    /// <summary>The camera that draws the call; null for all.</summary>
    public Camera camera { get; set; }
    public uint renderingLayerMask { get; set; }
    public MotionVectorGenerationMode motionVectorMode { get; set; }
}

public sealed class GL
{
    public static bool wireframe { get; set; }
}
