using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Play.Headless;

/// <summary>
/// Vertices as the shader finds them: mesh, properties of the renderer and texture of its material, by the textbook's form of dual
/// quaternion skinning.
/// </summary>
internal static class GpuSkinReader
{
    /// <summary>First joint of a renderer's block.</summary>
    public static int Start(Renderer renderer)
    {
        var properties = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(properties);
        return (int)properties.GetFloat("_SkinStart");
    }

    /// <summary>[vertex] Places and unit normals, mesh space.</summary>
    public static (float3[] Places, float3[] Normals) Deformed(Renderer renderer)
    {
        Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
        float4[][] joints = Joints(renderer, 0);
        return ([.. mesh.vertices.Select((place, v) => Moved(joints[v], (float3)place, 1f))],
            [.. mesh.normals.Select((normal, v) => math.normalize(Moved(joints[v], (float3)normal, 0f)))]);
    }

    /// <summary>[vertex] Places in the last picture, mesh space.</summary>
    public static float3[] Past(Renderer renderer)
    {
        float4[][] joints = Joints(renderer, (int)renderer.sharedMaterial.GetFloat("_SkinLast"));
        return [.. renderer.GetComponent<MeshFilter>().sharedMesh.vertices.Select(
            (place, v) => Moved(joints[v], (float3)place, 1f))];
    }

    // [vertex] Real and dual part of the normalised blend.
    private static float4[][] Joints(Renderer renderer, int past)
    {
        Color[] texels = ((Texture2D)renderer.sharedMaterial.GetTexture("_SkinMap")).GetPixels();
        int first = 2 * Start(renderer) + past;
        var corners = new List<Vector4>();
        renderer.GetComponent<MeshFilter>().sharedMesh.GetUVs(6, corners);
        return [.. corners.Select(corner =>
        {
            (float u, float v) = (corner.z, corner.w);
            int inner = (int)corner.x, behind = inner + (int)corner.y;
            float4 real = default, dual = default, pivot = Texel(inner, 0);
            foreach ((int joint, float weight) in new[]
                { (inner, (1 - u) * (1 - v)), (inner + 1, (1 - u) * v), (behind, u * (1 - v)), (behind + 1, u * v) })
            {
                float share = math.dot(Texel(joint, 0), pivot) < 0f ? -weight : weight;
                real += share * Texel(joint, 0);
                dual += share * Texel(joint, 1);
            }

            float norm = math.length(real);
            return new[] { real / norm, dual / norm };
        })];

        float4 Texel(int joint, int part)
        {
            Color texel = texels[first + 2 * joint + part];
            return new float4(texel.r, texel.g, texel.b, texel.a);
        }
    }

    // R p + t with t = 2 e q*.
    private static float3 Moved(float4[] joint, float3 place, float translation)
    {
        float3 q = joint[0].xyz, e = joint[1].xyz;
        float w = joint[0].w, ew = joint[1].w;
        float3 turned = (w * w - math.dot(q, q)) * place + 2f * math.dot(q, place) * q + 2f * w * math.cross(q, place);
        return turned + translation * 2f * (w * e - ew * q + math.cross(q, e));
    }
}
