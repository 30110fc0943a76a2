using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>One call that drew instances of a mesh.</summary>
[StandInExtension]
public sealed record DrawnBatch(
    Mesh Mesh, int Submesh, RenderParams Parameters, Matrix4x4[] Matrices, IReadOnlyDictionary<string, Vector4[]> Properties)
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

    internal static void Note<T>(in RenderParams parameters, Mesh mesh, int submesh, NativeArray<T> instances, int count, int start)
        where T : unmanaged
    {
        if (Calls == null)
            return;
        NativeArray<Matrix4x4> matrices = instances.Reinterpret<Matrix4x4>();
        var drawn = new Matrix4x4[count];
        NativeArray<Matrix4x4>.Copy(matrices, start, drawn, 0, count);
        Calls.Add(new DrawnBatch(mesh, submesh, parameters, drawn, parameters.matProps.CopyVectors()));
    }
}
