using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>Linear blend skinning as it is usually written: four 4×4 matrices a vertex.</summary>
internal static class PlainLinearBlend
{
    public static void Skin(PlainRig rig, float4x4[] palette, float3[] positions, float3[] normals)
    {
        for (var v = 0; v < positions.Length; v++)
        {
            var joints = rig.vertexJoints[v];
            var weights = rig.vertexWeights[v];
            var p = rig.meshVertices[v];
            var n = rig.meshNormals[v];
            positions[v] = weights.x * math.transform(palette[joints.x], p) + weights.y * math.transform(palette[joints.y], p)
                + weights.z * math.transform(palette[joints.z], p) + weights.w * math.transform(palette[joints.w], p);
            normals[v] = math.normalize(
                weights.x * math.rotate(palette[joints.x], n) + weights.y * math.rotate(palette[joints.y], n)
                + weights.z * math.rotate(palette[joints.z], n) + weights.w * math.rotate(palette[joints.w], n));
        }
    }

    /// <summary>Positions alone, of the rest shape in the wing frame.</summary>
    public static void SkinPositions(PlainRig rig, float4x4[] palette, float3[] positions)
    {
        for (var v = 0; v < positions.Length; v++)
        {
            var joints = rig.vertexJoints[v];
            var weights = rig.vertexWeights[v];
            var p = rig.vertices[v];
            positions[v] = weights.x * math.transform(palette[joints.x], p) + weights.y * math.transform(palette[joints.y], p)
                + weights.z * math.transform(palette[joints.z], p) + weights.w * math.transform(palette[joints.w], p);
        }
    }
}
