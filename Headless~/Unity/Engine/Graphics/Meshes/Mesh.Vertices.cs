using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector3[] vertices
    {
        get => ReadChannel<Vector3>(VertexAttribute.Position);
        set => WriteFloats<Vector3>(VertexAttribute.Position, value);
    }

    public Vector3[] normals
    {
        get => ReadChannel<Vector3>(VertexAttribute.Normal);
        set => WriteFloats<Vector3>(VertexAttribute.Normal, value);
    }

    public Vector4[] tangents
    {
        get => ReadChannel<Vector4>(VertexAttribute.Tangent);
        set => WriteFloats<Vector4>(VertexAttribute.Tangent, value);
    }

    public void GetVertices(List<Vector3> vertices) => Fill(vertices, this.vertices);
    public void GetNormals(List<Vector3> normals) => Fill(normals, this.normals);
    public void GetTangents(List<Vector4> tangents) => Fill(tangents, this.tangents);

    public void SetVertices(Vector3[] inVertices) => WriteFloats<Vector3>(VertexAttribute.Position, inVertices);
    public void SetVertices(List<Vector3> inVertices) => SetVertices(inVertices, 0, inVertices.Count);
    public void SetVertices(List<Vector3> inVertices, int start, int length) =>
        WriteList(VertexAttribute.Position, inVertices, start, length);
    public void SetVertices<T>(NativeArray<T> inVertices) where T : struct => SetVertices(inVertices, 0, inVertices.Length);
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length) where T : struct =>
        WriteNative(VertexAttribute.Position, inVertices, start, length, 3);
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length, MeshUpdateFlags flags) where T : struct =>
        SetVertices(inVertices, start, length);

    public void SetNormals(Vector3[] inNormals) => WriteFloats<Vector3>(VertexAttribute.Normal, inNormals);
    public void SetNormals(List<Vector3> inNormals) => SetNormals(inNormals, 0, inNormals.Count);
    public void SetNormals(List<Vector3> inNormals, int start, int length) =>
        WriteList(VertexAttribute.Normal, inNormals, start, length);
    public void SetNormals<T>(NativeArray<T> inNormals) where T : struct => SetNormals(inNormals, 0, inNormals.Length);
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length) where T : struct =>
        WriteNative(VertexAttribute.Normal, inNormals, start, length, 3);
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length, MeshUpdateFlags flags) where T : struct =>
        SetNormals(inNormals, start, length);

    public void SetTangents(Vector4[] inTangents) => WriteFloats<Vector4>(VertexAttribute.Tangent, inTangents);
    public void SetTangents(List<Vector4> inTangents) => SetTangents(inTangents, 0, inTangents.Count);
    public void SetTangents(List<Vector4> inTangents, int start, int length) =>
        WriteList(VertexAttribute.Tangent, inTangents, start, length);
    public void SetTangents<T>(NativeArray<T> inTangents) where T : struct => SetTangents(inTangents, 0, inTangents.Length);
    public void SetTangents<T>(NativeArray<T> inTangents, int start, int length) where T : struct =>
        WriteNative(VertexAttribute.Tangent, inTangents, start, length, 4);
}
