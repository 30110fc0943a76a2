using System;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>What the plain wing knows of its rig: managed arrays of structures, wing frame and wing lengths unless said otherwise.</summary>
internal sealed unsafe class PlainRig
{
    public readonly int chains;
    public readonly int joints;
    public readonly float3 leadingEdge;
    public readonly float[] chainRatio;
    public readonly float[] jointRatio;
    public readonly float3[] restJoints;
    public readonly float3[] bones;
    public readonly float3[] boneDirections;
    public readonly float3[] bendAxes;
    public readonly float3[] crossDirections;
    public readonly float[] masses;
    public readonly float[] inertias;
    public readonly float[] leverDamping;
    public readonly Spring[] springs;
    public readonly int[] triangles;

    /// <summary>Rest positions of the vertices, wing frame.</summary>
    public readonly float3[] vertices;

    /// <summary>The same in mesh space, with the normals.</summary>
    public readonly float3[] meshVertices;
    public readonly float3[] meshNormals;

    public readonly int4[] vertexJoints;
    public readonly float4[] vertexWeights;

    public PlainRig(Specimen specimen)
    {
        ref readonly var rig = ref specimen.Rig.View;
        var frame = specimen.Rig.Frame;
        chains = rig.chainCount;
        joints = rig.jointsPerChain;
        leadingEdge = rig.leadingEdge;
        chainRatio = Copy(rig.chainRatio, chains);
        jointRatio = Copy(rig.jointRatio, joints);
        restJoints = Copy(rig.restJoints, rig.jointCount);
        bones = Copy(rig.bones, rig.boneCount);
        boneDirections = Copy(rig.boneDirections, rig.boneCount);
        bendAxes = Copy(rig.bendAxes, rig.boneCount);
        crossDirections = Copy(rig.crossDirections, rig.boneCount);
        masses = Copy(rig.jointMasses, rig.jointCount);
        inertias = Copy(rig.jointInertias, rig.boneCount);
        leverDamping = Copy(rig.leverDamping, rig.jointCount * joints);
        springs = Copy(rig.springs, rig.springCount);
        triangles = specimen.Surface.triangles;
        meshVertices = Array.ConvertAll(specimen.Surface.positions, p => (float3)p);
        meshNormals = Array.ConvertAll(specimen.Surface.normals, n => (float3)n);
        vertices = Array.ConvertAll(meshVertices, frame.ToWing);
        vertexJoints = specimen.Rig.VertexJoints.ToArray();
        vertexWeights = specimen.Rig.VertexWeights.ToArray();
    }

    public int JointCount => chains * joints;

    public int BonesPerChain => joints - 1;

    public int BoneCount => chains * (joints - 1);

    private static T[] Copy<T>(T* source, int count) where T : unmanaged => new ReadOnlySpan<T>(source, count).ToArray();
}
