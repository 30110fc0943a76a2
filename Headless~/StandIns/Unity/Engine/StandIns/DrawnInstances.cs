using System.Collections.Generic;
using System.Linq;
using System.Reflection;
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
        FieldInfo field = typeof(T).GetField(name);
        if (typeof(T) == typeof(Matrix4x4))
            return name == "objectToWorld" ? instances.Skip(start).Take(count).Select(value => (Matrix4x4)(object)value).ToArray() : null;
        return field == null ? null : instances.Skip(start).Take(count).Select(value => (Matrix4x4)field.GetValue(value)).ToArray();
    }
}
