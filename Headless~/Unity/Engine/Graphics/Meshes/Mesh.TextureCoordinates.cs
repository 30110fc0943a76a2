using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector2[] uv
    {
        get => ReadChannel<Vector2>(VertexAttribute.TexCoord0);
        set => WriteFloats<Vector2>(VertexAttribute.TexCoord0, value);
    }

    public Vector2[] uv2
    {
        get => ReadChannel<Vector2>(VertexAttribute.TexCoord1);
        set => WriteFloats<Vector2>(VertexAttribute.TexCoord1, value);
    }

    public Vector2[] uv3
    {
        get => ReadChannel<Vector2>(VertexAttribute.TexCoord2);
        set => WriteFloats<Vector2>(VertexAttribute.TexCoord2, value);
    }

    public Vector2[] uv4
    {
        get => ReadChannel<Vector2>(VertexAttribute.TexCoord3);
        set => WriteFloats<Vector2>(VertexAttribute.TexCoord3, value);
    }

    public void GetUVs(int channel, List<Vector2> uvs) => Fill(uvs, ReadChannel<Vector2>(Coordinates(channel)));
    public void GetUVs(int channel, List<Vector3> uvs) => Fill(uvs, ReadChannel<Vector3>(Coordinates(channel)));
    public void GetUVs(int channel, List<Vector4> uvs) => Fill(uvs, ReadChannel<Vector4>(Coordinates(channel)));
    public void SetUVs(int channel, List<Vector2> uvs) => WriteFloats<Vector2>(Coordinates(channel), uvs.ToArray());
    public void SetUVs(int channel, List<Vector3> uvs) => WriteFloats<Vector3>(Coordinates(channel), uvs.ToArray());
    public void SetUVs(int channel, List<Vector4> uvs) => WriteFloats<Vector4>(Coordinates(channel), uvs.ToArray());
    public void SetUVs(int channel, Vector2[] uvs) => WriteFloats<Vector2>(Coordinates(channel), uvs);
    public void SetUVs(int channel, Vector3[] uvs) => WriteFloats<Vector3>(Coordinates(channel), uvs);
    public void SetUVs(int channel, Vector4[] uvs) => WriteFloats<Vector4>(Coordinates(channel), uvs);

    private static VertexAttribute Coordinates(int channel)
    {
        if (channel is < 0 or > 7)
            throw new IndexOutOfRangeException($"The UV index is invalid. Must be in the range 0 to 7, is {channel}.");
        return VertexAttribute.TexCoord0 + channel;
    }
}
