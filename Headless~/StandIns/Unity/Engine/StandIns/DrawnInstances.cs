using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>One call that drew instances of a mesh; the last matrices are null where it gave none.</summary>
[StandInExtension]
public sealed record DrawnBatch(
    Mesh Mesh, int Submesh, RenderParams Parameters, Matrix4x4[] Matrices, Matrix4x4[] LastMatrices,
    IReadOnlyDictionary<string, Vector4[]> Properties)
{
    public Material Material => Parameters.material;

    public Camera Camera => Parameters.camera;
}

/// <summary>Instances that were drawn, kept while a test looks.</summary>
[StandInExtension]
public static class DrawnInstances
{
    /// <summary>Calls since it was set; null keeps none.</summary>
    public static List<DrawnBatch> Calls { get; set; }

    internal static void Note(in RenderParams parameters, Mesh mesh, int submesh, Matrix4x4 place) =>
        Calls?.Add(new DrawnBatch(mesh, submesh, parameters, [place], null, new Dictionary<string, Vector4[]>()));

    internal static void Note<T>(in RenderParams parameters, Mesh mesh, int submesh, NativeArray<T> instances, int count, int start)
        where T : unmanaged
    {
        if (Calls == null)
            return;
        Matrix4x4[] drawn = Read(instances, "objectToWorld", count, start);
        Matrix4x4[] last = Read(instances, "prevObjectToWorld", count, start);
        Calls.Add(new DrawnBatch(mesh, submesh, parameters, drawn, last, parameters.matProps.CopyVectors()));
    }

    // As Unity does: matrices alone, or a struct with fields of certain names.
    private static Matrix4x4[] Read<T>(NativeArray<T> instances, string name, int count, int start) where T : unmanaged
    {
        bool isMatrix = typeof(T) == typeof(Matrix4x4);
        if (isMatrix ? name != "objectToWorld" : typeof(T).GetField(name) == null)
            return null;
        int offset = isMatrix ? 0 : (int)Marshal.OffsetOf<T>(name), size = Unsafe.SizeOf<T>();
        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(instances.AsReadOnlySpan());
        var places = new Matrix4x4[count];
        for (int k = 0; k < count; k++)
            places[k] = MemoryMarshal.Read<Matrix4x4>(bytes[((start + k) * size + offset)..]);
        return places;
    }
}
