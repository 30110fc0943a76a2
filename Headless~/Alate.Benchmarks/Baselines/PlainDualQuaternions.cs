using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// Dual-quaternion skinning as it is usually written: vertex by vertex, four joints and weights each, signs aligned and the blend
/// normalised for every vertex.
/// </summary>
internal static class PlainDualQuaternions
{
    public static void Skin(PlainRig rig, DualQuaternion[] palette, float3[] positions, float3[] normals)
    {
        for (var v = 0; v < positions.Length; v++)
        {
            var joints = rig.vertexJoints[v];
            var weights = rig.vertexWeights[v];
            var pivot = palette[joints.x].real;
            var real = pivot * weights.x;
            var dual = palette[joints.x].dual * weights.x;
            Add(palette[joints.y], pivot, weights.y, ref real, ref dual);
            Add(palette[joints.z], pivot, weights.z, ref real, ref dual);
            Add(palette[joints.w], pivot, weights.w, ref real, ref dual);

            var scale = 1f / math.length(real);
            real *= scale;
            dual *= scale;
            var rotation = new quaternion(real);
            var translation = 2f * (real.w * dual.xyz - dual.w * real.xyz + math.cross(real.xyz, dual.xyz));
            positions[v] = math.rotate(rotation, rig.meshVertices[v]) + translation;
            normals[v] = math.rotate(rotation, rig.meshNormals[v]);
        }
    }

    private static void Add(in DualQuaternion joint, float4 pivot, float weight, ref float4 real, ref float4 dual)
    {
        if (math.dot(joint.real, pivot) < 0f)
            weight = -weight;
        real += joint.real * weight;
        dual += joint.dual * weight;
    }
}
