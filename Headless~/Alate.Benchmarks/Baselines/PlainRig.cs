using System;
using System.Numerics;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// Rig of the plain wing. The baselines are written as first written in .NET: managed arrays of the vectors, quaternions and matrices of
/// System.Numerics, wing after wing, vertex after vertex. Wing frame and wing lengths unless said otherwise.
/// </summary>
internal sealed unsafe class PlainRig
{
    public readonly int chains;
    public readonly int joints;
    public readonly Vector3 leadingEdge;
    public readonly float[] chainRatio;
    public readonly float[] jointRatio;
    public readonly Vector3[] restJoints;
    public readonly Vector3[] bones;
    public readonly Vector3[] boneDirections;
    public readonly Vector3[] bendAxes;
    public readonly Vector3[] crossDirections;
    public readonly float[] masses;
    public readonly float[] inertias;
    public readonly float[] leverDamping;
    public readonly Spring[] springs;
    public readonly int[] triangles;
    public readonly PlainVertex[] vertices;

    public PlainRig(Specimen specimen)
    {
        ref readonly RigView rig = ref specimen.Rig.View;
        chains = rig.chainCount;
        joints = rig.jointsPerChain;
        leadingEdge = Plain(rig.leadingEdge);
        chainRatio = Copy(rig.chainRatio, chains);
        jointRatio = Copy(rig.jointRatio, joints);
        restJoints = Array.ConvertAll(Copy(rig.restJoints, rig.jointCount), Plain);
        bones = Array.ConvertAll(Copy(rig.bones, rig.boneCount), Plain);
        boneDirections = Array.ConvertAll(Copy(rig.boneDirections, rig.boneCount), Plain);
        bendAxes = Array.ConvertAll(Copy(rig.bendAxes, rig.boneCount), Plain);
        crossDirections = Array.ConvertAll(Copy(rig.crossDirections, rig.boneCount), Plain);
        masses = Copy(rig.jointMasses, rig.jointCount);
        inertias = Copy(rig.jointInertias, rig.boneCount);
        leverDamping = Copy(rig.leverDamping, rig.jointCount * joints);
        springs = Copy(rig.springs, rig.springCount);
        triangles = specimen.Surface.triangles;
        vertices = new PlainVertex[specimen.Surface.VertexCount];
        for (int v = 0; v < vertices.Length; v++)
            vertices[v] = Vertex(specimen, v);
    }

    public int JointCount => chains * joints;

    public int BonesPerChain => joints - 1;

    public int BoneCount => chains * (joints - 1);

    public static Vector3 Plain(float3 v) => new(v.x, v.y, v.z);

    public static Quaternion Plain(float4 q) => new(q.x, q.y, q.z, q.w);

    private static PlainVertex Vertex(Specimen specimen, int v)
    {
        var position = (float3)specimen.Surface.positions[v];
        var vertex = new PlainVertex
        {
            position = Plain(specimen.Rig.Frame.ToWing(position)),
            meshPosition = Plain(position),
            meshNormal = Plain(specimen.Surface.normals[v]),
        };
        for (int k = 0; k < 4; k++)
        {
            vertex.joints[k] = specimen.Rig.VertexJoints[v][k];
            vertex.weights[k] = specimen.Rig.VertexWeights[v][k];
        }

        return vertex;
    }

    private static T[] Copy<T>(T* source, int count) where T : unmanaged => new ReadOnlySpan<T>(source, count).ToArray();
}
