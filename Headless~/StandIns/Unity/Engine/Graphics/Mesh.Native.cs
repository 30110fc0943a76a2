using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Attributes from native arrays, and from parts of lists.</summary>
public sealed partial class Mesh
{
    public void SetVertices(List<Vector3> inVertices, int start, int length) => SetVertices(inVertices.GetRange(start, length));
    public void SetVertices<T>(NativeArray<T> inVertices) where T : struct => SetVertices(inVertices, 0, inVertices.Length);
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length) where T : struct =>
        SetVertices(Part<T, Vector3>(inVertices, start, length));
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length, MeshUpdateFlags flags) where T : struct =>
        SetVertices(inVertices, start, length);

    public void SetNormals<T>(NativeArray<T> inNormals) where T : struct => SetNormals(inNormals, 0, inNormals.Length);
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length) where T : struct =>
        SetNormals(Part<T, Vector3>(inNormals, start, length));
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length, MeshUpdateFlags flags) where T : struct =>
        SetNormals(inNormals, start, length);

    public void SetTangents<T>(NativeArray<T> inTangents) where T : struct => SetTangents(inTangents, 0, inTangents.Length);
    public void SetTangents<T>(NativeArray<T> inTangents, int start, int length) where T : struct =>
        SetTangents(Part<T, Vector4>(inTangents, start, length));
    public void SetTangents<T>(NativeArray<T> inTangents, int start, int length, MeshUpdateFlags flags) where T : struct =>
        SetTangents(inTangents, start, length);

    public void SetUVs<T>(int channel, NativeArray<T> uvs) where T : struct => SetUVs(channel, uvs, 0, uvs.Length);

    public void SetUVs<T>(int channel, NativeArray<T> uvs, int start, int length) where T : struct
    {
        switch (Unsafe.SizeOf<T>() / sizeof(float))
        {
            case 2: SetUVs(channel, Part<T, Vector2>(uvs, start, length)); break;
            case 3: SetUVs(channel, Part<T, Vector3>(uvs, start, length)); break;
            default: SetUVs(channel, Part<T, Vector4>(uvs, start, length)); break;
        }
    }

    public void SetUVs(int channel, Vector3[] uvs) => SetCoordinates(channel, uvs);
    public void SetUVs(int channel, Vector4[] uvs) => SetCoordinates(channel, uvs);
    public void SetUVs(int channel, List<Vector3> uvs) => SetCoordinates(channel, uvs.ToArray());
    public void SetUVs(int channel, List<Vector4> uvs) => SetCoordinates(channel, uvs.ToArray());
    public void GetUVs(int channel, List<Vector3> uvs) => Fill(uvs, Get<Vector3>(Channel(channel)));
    public void GetUVs(int channel, List<Vector4> uvs) => Fill(uvs, Get<Vector4>(Channel(channel)));

    public void GetColors(List<Color> colors) => Fill(colors, this.colors);
    public void GetColors(List<Color32> colors) => Fill(colors, colors32);
    public void SetColors(List<Color> inColors) => colors = inColors.ToArray();
    public void SetColors(List<Color32> inColors) => colors32 = inColors.ToArray();
    public void SetColors(Color[] inColors) => colors = inColors;
    public void SetColors(Color32[] inColors) => colors32 = inColors;

    private void SetCoordinates<T>(int channel, T[] uvs) where T : unmanaged
    {
        VertexAttribute attribute = Channel(channel);
        if (_vertices.Has(attribute) && _vertices.Find(attribute).dimension != Components<T>() && CanWrite(attribute.ToString()))
            Relayout(attribute, null);
        Set<T>(attribute, uvs);
    }

    private static TTo[] Part<TFrom, TTo>(NativeArray<TFrom> values, int start, int length) where TFrom : struct where TTo : unmanaged
    {
        if (Unsafe.SizeOf<TFrom>() != Unsafe.SizeOf<TTo>())
        {
            throw new ArgumentException(
                $"The elements of the array must have {Unsafe.SizeOf<TTo>()} bytes, as {typeof(TTo).Name} has; "
                + $"they have {Unsafe.SizeOf<TFrom>()}.");
        }

        CheckPart(values.Length, start, length);
        return MemoryMarshal.Cast<TFrom, TTo>(values.AsReadOnlySpan().Slice(start, length)).ToArray();
    }
}
