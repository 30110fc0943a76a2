using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>A joint's transform as a dual quaternion.</summary>
internal struct PlainDualQuaternion
{
    public Quaternion real;
    public Quaternion dual;
}

/// <summary>Skinning as it is usually written: vertex by vertex, four joints and weights each.</summary>
internal static class PlainSkinning
{
    /// <summary>Dual quaternions: signs aligned to the first joint and the blend normalised for every vertex.</summary>
    public static void DualQuaternions(PlainVertex[] vertices, PlainDualQuaternion[] palette, Vector3[] positions, Vector3[] normals)
    {
        for (int v = 0; v < vertices.Length; v++)
        {
            ref readonly PlainVertex vertex = ref vertices[v];
            Quaternion pivot = palette[vertex.joints[0]].real;
            Quaternion real = default, dual = default;
            for (int k = 0; k < 4; k++)
            {
                ref readonly PlainDualQuaternion joint = ref palette[vertex.joints[k]];
                float weight = vertex.weights[k];
                if (Quaternion.Dot(joint.real, pivot) < 0f)
                    weight = -weight;
                real += joint.real * weight;
                dual += joint.dual * weight;
            }

            float scale = 1f / real.Length();
            real *= scale;
            dual *= scale;
            positions[v] = Vector3.Transform(vertex.meshPosition, real) + Translation(real, dual);
            normals[v] = Vector3.Transform(vertex.meshNormal, real);
        }
    }

    /// <summary>Linear blending of 4×4 matrices.</summary>
    public static void LinearBlend(PlainVertex[] vertices, Matrix4x4[] palette, Vector3[] positions, Vector3[] normals)
    {
        for (int v = 0; v < vertices.Length; v++)
        {
            ref readonly PlainVertex vertex = ref vertices[v];
            Matrix4x4 blend = Blend(vertex, palette);
            positions[v] = Vector3.Transform(vertex.meshPosition, blend);
            normals[v] = Vector3.Normalize(Vector3.TransformNormal(vertex.meshNormal, blend));
        }
    }

    /// <summary>Skins positions alone, in the wing frame.</summary>
    public static void Positions(PlainVertex[] vertices, Matrix4x4[] palette, Vector3[] positions)
    {
        for (int v = 0; v < vertices.Length; v++)
            positions[v] = Vector3.Transform(vertices[v].position, Blend(vertices[v], palette));
    }

    public static Vector3 Translation(Quaternion real, Quaternion dual)
    {
        Vector3 r = new(real.X, real.Y, real.Z), d = new(dual.X, dual.Y, dual.Z);
        return 2f * (real.W * d - dual.W * r + Vector3.Cross(r, d));
    }

    private static Matrix4x4 Blend(in PlainVertex vertex, Matrix4x4[] palette) =>
        palette[vertex.joints[0]] * vertex.weights[0] + palette[vertex.joints[1]] * vertex.weights[1]
        + palette[vertex.joints[2]] * vertex.weights[2] + palette[vertex.joints[3]] * vertex.weights[3];
}
