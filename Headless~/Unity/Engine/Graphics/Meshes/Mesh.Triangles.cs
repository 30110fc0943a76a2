using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine;

public sealed partial class Mesh
{
    public int[] triangles
    {
        get
        {
            if (!CanAccess("triangles/indices"))
                return [];
            var all = new List<int>(_indices.Length);
            for (int part = 0; part < _indices.PartCount; part++)
            {
                if (_indices.Part(part).topology == MeshTopology.Triangles)
                    all.AddRange(Absolute(part, true));
            }

            return [.. all];
        }
        set
        {
            if (!CanAccess("triangles/indices"))
                return;
            _indices.SetPartCount(1);
            SetPart("triangles", value, MeshTopology.Triangles, 0, true, 0);
        }
    }

    public int[] GetTriangles(int submesh) => GetTriangles(submesh, true);

    public int[] GetTriangles(int submesh, bool applyBaseVertex)
    {
        if (!CanAccessPart("triangles", submesh))
            return [];
        if (_indices.Part(submesh).topology == MeshTopology.Triangles)
            return Absolute(submesh, applyBaseVertex);
        Debug.LogError($"Failed getting triangles. Submesh topology is {_indices.Part(submesh).topology}.", this);
        return [];
    }

    public void GetTriangles(List<int> triangles, int submesh) => Fill(triangles, GetTriangles(submesh));
    public void GetTriangles(List<int> triangles, int submesh, bool applyBaseVertex) =>
        Fill(triangles, GetTriangles(submesh, applyBaseVertex));

    public void SetTriangles(int[] triangles, int submesh) => SetTriangles(triangles, submesh, true, 0);
    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) => SetTriangles(triangles, submesh, calculateBounds, 0);
    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart("triangles", triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles, submesh, true, 0);
    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds) =>
        SetTriangles(triangles, submesh, calculateBounds, 0);
    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart("triangles", CollectionsMarshal.AsSpan(triangles), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    private int[] Absolute(int part, bool applyBaseVertex)
    {
        int[] values = _indices.Values(part).ToArray();
        int shift = applyBaseVertex ? _indices.Part(part).baseVertex : 0;
        for (int i = 0; i < values.Length; i++)
            values[i] += shift;
        return values;
    }

    private bool CanAccessPart(string what, int part)
    {
        if (!CanAccess("triangles/indices"))
            return false;
        if ((uint)part < (uint)_indices.PartCount)
            return true;
        Debug.LogError($"Failed getting {what}. Submesh index is out of bounds.", this);
        return false;
    }

    private void SetPart(string what, ReadOnlySpan<int> values, MeshTopology topology, int part, bool calculateBounds, int baseVertex)
    {
        if (!CanAccess("triangles/indices"))
            return;
        string problem = Problem(values, topology, part, baseVertex);
        if (problem != null)
        {
            Debug.LogError($"Failed setting {what}. {problem}", this);
            return;
        }

        _indices.Replace(part, values, topology, baseVertex);
        if (calculateBounds)
            RecalculateBounds();
    }

    private string Problem(ReadOnlySpan<int> values, MeshTopology topology, int part, int baseVertex)
    {
        if ((uint)part >= (uint)_indices.PartCount)
            return $"Submesh index {part} is out of bounds: the mesh has {_indices.PartCount} submeshes.";
        int corners = topology switch { MeshTopology.Triangles => 3, MeshTopology.Quads => 4, MeshTopology.Lines => 2, _ => 1 };
        if (values.Length % corners != 0)
            return $"The number of supplied {topology} indices must be a multiple of {corners}.";
        foreach (int value in values)
        {
            if ((uint)(value + baseVertex) >= (uint)vertexCount)
                return $"Some indices are referencing out of bounds vertices. IndexCount: {values.Length}, VertexCount: {vertexCount}";
            if (value > ushort.MaxValue && _indices.Format == Rendering.IndexFormat.UInt16)
                return $"Index {value} does not fit into the 16 bits of the mesh's indexFormat.";
        }

        return null;
    }
}
