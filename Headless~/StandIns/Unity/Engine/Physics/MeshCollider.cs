namespace UnityEngine;

/// <summary>A collider that rays do not meet here.</summary>
public class MeshCollider : Collider
{
    public Mesh sharedMesh { get; set; }

    private protected override void CopyShapeTo(Collider copy) => ((MeshCollider)copy).sharedMesh = sharedMesh;
}
