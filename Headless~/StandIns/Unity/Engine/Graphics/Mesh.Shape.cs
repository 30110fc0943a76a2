using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Normals from triangles, and what a skin needs.</summary>
public sealed partial class Mesh
{
    private Matrix4x4[] _bindposes = [];
    private BoneWeight[] _boneWeights = [];

    public Matrix4x4[] bindposes
    {
        get => (Matrix4x4[])Alive()._bindposes.Clone();
        set => Alive()._bindposes = (Matrix4x4[])value?.Clone() ?? [];
    }

    public BoneWeight[] boneWeights
    {
        get => CanRead("bone weights") ? (BoneWeight[])_boneWeights.Clone() : [];
        set
        {
            if (!CanWrite("bone weights"))
                return;
            if (value is { Length: > 0 } && value.Length != _vertices.Count)
            {
                Debug.LogError("Mesh.boneWeights is out of bounds. "
                    + "The supplied array needs to be the same size as the Mesh.vertices array.", this);
            }
            else
            {
                _boneWeights = (BoneWeight[])value?.Clone() ?? [];
            }
        }
    }

    public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);

    public void RecalculateNormals(MeshUpdateFlags flags)
    {
        Vector3[] positions = vertices;
        var sums = new Vector3[positions.Length];
        int[] corners = triangles;
        for (int t = 0; t + 2 < corners.Length; t += 3)
        {
            (int a, int b, int c) = (corners[t], corners[t + 1], corners[t + 2]);
            var normal = Vector3.Cross(positions[b] - positions[a], positions[c] - positions[a]);
            sums[a] += normal;
            sums[b] += normal;
            sums[c] += normal;
        }

        for (int v = 0; v < sums.Length; v++)
            sums[v] = sums[v].sqrMagnitude > 0f ? sums[v] / sums[v].magnitude : Vector3.zero;
        normals = sums;
    }

    private void ClearSkin()
    {
        _bindposes = [];
        _boneWeights = [];
        _shapes = [];
    }
}

public struct BoneWeight
{
    public float weight0 { get; set; }
    public float weight1 { get; set; }
    public float weight2 { get; set; }
    public float weight3 { get; set; }
    public int boneIndex0 { get; set; }
    public int boneIndex1 { get; set; }
    public int boneIndex2 { get; set; }
    public int boneIndex3 { get; set; }
}
