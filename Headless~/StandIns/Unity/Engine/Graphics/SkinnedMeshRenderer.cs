using System;
using System.Collections.Generic;

namespace UnityEngine;

public class SkinnedMeshRenderer : Renderer, IReferring
{
    private Mesh _mesh;
    private Transform[] _bones = [];
    private readonly Dictionary<int, float> _shapeWeights = [];

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
        }
    }

    public Transform[] bones
    {
        get => (Transform[])_bones.Clone();
        set => _bones = (Transform[])value.Clone();
    }

    public Transform rootBone { get; set; }
    public bool updateWhenOffscreen { get; set; }

    private protected override Bounds ShapeBounds => _mesh != null ? _mesh.bounds : default;

    private protected override Matrix4x4 BoundsToWorld => rootBone != null ? rootBone.localToWorldMatrix : localToWorldMatrix;

    /// <summary>In percent.</summary>
    public float GetBlendShapeWeight(int index)
    {
        CheckShape(index);
        return _shapeWeights.GetValueOrDefault(index);
    }

    public void SetBlendShapeWeight(int index, float value)
    {
        CheckShape(index);
        _shapeWeights[index] = value;
    }

    public void BakeMesh(Mesh mesh) => BakeMesh(mesh, false);

    /// <summary>Writes the posed vertices into a mesh, relative to this transform, with its scale only if asked to use it.</summary>
    public void BakeMesh(Mesh mesh, bool useScale)
    {
        if (_mesh == null)
            throw new InvalidOperationException("The renderer has no mesh to bake.");
        Matrix4x4 toLocal = useScale
            ? transform.worldToLocalMatrix
            : Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one).inverse;
        Vector3[] positions = _mesh.vertices, normals = _mesh.normals;
        BoneWeight[] weights = _mesh.boneWeights;
        Matrix4x4[] bind = _mesh.bindposes;
        foreach (float weight in _shapeWeights.Values)
        {
            if (weight != 0f)
                throw new NotSupportedException("The stand-in bakes no blend shapes.");
        }

        for (int v = 0; v < positions.Length; v++)
        {
            Matrix4x4 pose = toLocal * (weights.Length > 0 ? Pose(weights[v], bind) : localToWorldMatrix);
            positions[v] = pose.MultiplyPoint3x4(positions[v]);
            if (normals.Length > 0)
                normals[v] = pose.MultiplyVector(normals[v]).normalized;
        }

        mesh.Clear();
        mesh.indexFormat = _mesh.indexFormat;
        mesh.vertices = positions;
        mesh.normals = normals;
        mesh.tangents = _mesh.tangents;
        mesh.uv = _mesh.uv;
        mesh.subMeshCount = _mesh.subMeshCount;
        for (int part = 0; part < _mesh.subMeshCount; part++)
            mesh.SetIndices(_mesh.GetIndices(part), _mesh.GetTopology(part), part);
    }

    private protected override void CopyShapeTo(Renderer copy)
    {
        var to = (SkinnedMeshRenderer)copy;
        to._mesh = _mesh;
        to._bones = [.. _bones];
        to.rootBone = rootBone;
        foreach ((int shape, float weight) in _shapeWeights)
            to._shapeWeights[shape] = weight;
        to.updateWhenOffscreen = updateWhenOffscreen;
    }

    void IReferring.Redirect(IReadOnlyDictionary<Object, Object> copies)
    {
        RedirectAnchors(copies);
        _bones = Array.ConvertAll(_bones, b => (Transform)Copying.Twin(b, copies));
        rootBone = (Transform)Copying.Twin(rootBone, copies);
    }

    private void CheckShape(int index)
    {
        CheckAlive();
        if (_mesh == null || (uint)index >= (uint)_mesh.blendShapeCount)
            throw new ArgumentOutOfRangeException(nameof(index), index, "The mesh has no such blend shape.");
    }

    private Matrix4x4 Pose(BoneWeight w, Matrix4x4[] bind)
    {
        Matrix4x4 pose = default;
        Add(ref pose, w.boneIndex0, w.weight0, bind);
        Add(ref pose, w.boneIndex1, w.weight1, bind);
        Add(ref pose, w.boneIndex2, w.weight2, bind);
        Add(ref pose, w.boneIndex3, w.weight3, bind);
        return pose;
    }

    private void Add(ref Matrix4x4 pose, int bone, float weight, Matrix4x4[] bind)
    {
        if (weight == 0f || bone >= _bones.Length || _bones[bone] == null)
            return;
        Matrix4x4 m = _bones[bone].localToWorldMatrix * bind[bone];
        for (int i = 0; i < 16; i++)
            pose[i] += weight * m[i];
    }
}
