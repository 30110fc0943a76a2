namespace UnityEngine;

public sealed class MeshFilter : Component, IStateful
{
    private Mesh _mesh;
    private bool _isOwn;

    public Mesh sharedMesh
    {
        get
        {
            CheckAlive();
            return _mesh;
        }
        set
        {
            CheckAlive();
            _mesh = value;
            _isOwn = false;
        }
    }

    /// <summary>A copy of the shared mesh for this filter alone, made at the first asking. Nobody destroys it but who asked.</summary>
    public Mesh mesh
    {
        get
        {
            CheckAlive();
            if (_mesh == null)
                sharedMesh = new Mesh { name = "" };
            else if (!_isOwn)
                _mesh = Own(_mesh);
            _isOwn = true;
            return _mesh;
        }
        set => sharedMesh = value;
    }

    void IStateful.CopyStateTo(Component copy) => ((MeshFilter)copy)._mesh = _mesh;

    private Mesh Own(Mesh shared)
    {
        if (!Application.isPlaying)
        {
            Debug.LogError("Instantiating mesh due to calling MeshFilter.mesh during edit mode. This will leak meshes. "
                + "Please use MeshFilter.sharedMesh instead.", this);
        }

        Mesh own = Instantiate(shared);
        own.name = shared.name + " Instance";
        return own;
    }
}
