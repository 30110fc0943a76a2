namespace UnityEngine;

public class MeshRenderer : Renderer
{
    private protected override Bounds ShapeBounds =>
        TryGetComponent(out MeshFilter filter) && filter.sharedMesh != null ? filter.sharedMesh.bounds : default;
}
