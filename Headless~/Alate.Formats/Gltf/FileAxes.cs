using Unity.Mathematics;
using UnityEngine;

namespace Alate.Formats;

/// <summary>Takes points of an insect's space (left-handed, X right, Y up, Z ahead) to those of file formats, metres.</summary>
internal static class FileAxes
{
    /// <summary>glTF is right-handed with Y up: an insect that faces +Z has its right wing at −X.</summary>
    public static float3 ToGltf(float3 insect) => new(-insect.x, insect.y, insect.z);

    /// <summary>A rotation, seen in that mirror.</summary>
    public static quaternion ToGltf(quaternion insect) => new(insect.value.x, -insect.value.y, -insect.value.z, insect.value.w);

    /// <summary>Blender's axes, right-handed with Z up, as its glTF importer lays them: OpenVAT's textures have these.</summary>
    public static float3 ToBlender(float3 insect)
    {
        float3 gltf = ToGltf(insect);
        return new float3(gltf.x, -gltf.z, gltf.y);
    }

    /// <summary>A unit normal in glTF's axes.</summary>
    public static float3 Unit(float3 normal) => math.normalizesafe(ToGltf(normal), new float3(0f, 1f, 0f));

    /// <inheritdoc cref="Unit(float3)"/>
    public static float3 Unit(Vector3 normal) => Unit((float3)normal);
}
