using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Cli;

/// <summary>Part of a mesh as the graphics card has it.</summary>
/// <param name="Places">[vertex] Units of the mesh.</param>
/// <param name="Normals">[vertex] Unit vectors.</param>
/// <param name="Triangles">Three vertex indices a triangle.</param>
/// <param name="Coordinates">[vertex] Where in the texture; null where it has none.</param>
/// <param name="Baked">[vertex] Where in the texture of baked loops; null where it has none.</param>
/// <param name="Joints">[vertex] First joint of its cell, joints to the next chain, place in the cell; null where it has none.</param>
/// <param name="Colours">[vertex] Linear light and opacity; null where it has none.</param>
internal sealed record MeshShape(
    float3[] Places, float3[] Normals, int[] Triangles, float2[] Coordinates, float2[] Baked, float4[] Joints, float4[] Colours)
{
    /// <summary>Attribute of a mesh that has the joints of its vertices, for the graphics card to deform it.</summary>
    public const VertexAttribute JointAttribute = VertexAttribute.TexCoord6;

    /// <summary>A submesh, whether scripts may read it or not.</summary>
    public static MeshShape Of(Mesh mesh, int part)
    {
        bool isReadable = mesh.isReadable;
        mesh.SetReadable(true);
        float2[] coordinates = Array.ConvertAll(mesh.uv, uv => (float2)uv), baked = Array.ConvertAll(mesh.uv2, uv => (float2)uv);
        var joints = new List<Vector4>();
        mesh.GetUVs(JointAttribute - VertexAttribute.TexCoord0, joints);
        float4[] colours = Array.ConvertAll(mesh.colors, colour => Shading.Linear(colour));
        var shape = new MeshShape(
            Array.ConvertAll(mesh.vertices, place => (float3)place), Array.ConvertAll(mesh.normals, normal => (float3)normal),
            mesh.GetTriangles(part), OrNull(coordinates), OrNull(baked),
            OrNull(joints.Select(joint => (float4)joint).ToArray()), OrNull(colours));
        mesh.SetReadable(isReadable);
        return shape;
    }

    /// <summary>The shape in the scene.</summary>
    /// <param name="place">From the mesh to the scene.</param>
    /// <param name="look">Its material.</param>
    public SceneSurface Placed(float4x4 place, SceneLook look)
    {
        float3x3 turn = math.transpose(math.inverse(new float3x3(place.c0.xyz, place.c1.xyz, place.c2.xyz)));
        return new SceneSurface(
            Array.ConvertAll(Places, one => math.transform(place, one)),
            Array.ConvertAll(Normals, normal => math.normalizesafe(math.mul(turn, normal))), Triangles, Coordinates, Colours, look);
    }

    private static T[] OrNull<T>(T[] values) => values.Length == 0 ? null : values;
}
