using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>The frames that carry one wing's skin: each bone swung onto its elastic direction and rolled after its neighbours.</summary>
internal sealed class PlainFrames
{
    private const float k_LargestRoll = MathF.PI / 3f;

    private readonly PlainRig m_Rig;
    private readonly Quaternion[] m_Bones;

    /// <summary>Per joint.</summary>
    public readonly Quaternion[] rotations;

    public PlainFrames(PlainRig rig)
    {
        m_Rig = rig;
        m_Bones = new Quaternion[rig.BoneCount];
        rotations = new Quaternion[rig.JointCount];
    }

    public void Evaluate(Vector3[] positions, Quaternion[] bent)
    {
        for (int bone = 0; bone < m_Bones.Length; bone++)
            m_Bones[bone] = Bone(positions, bent[bone], bone);
        for (int joint = 0; joint < rotations.Length; joint++)
        {
            int i = joint / m_Rig.joints, j = joint % m_Rig.joints, bone = joint - i;
            rotations[joint] = j == 0 ? m_Bones[bone]
                : j == m_Rig.joints - 1 ? m_Bones[bone - 1]
                : Quaternion.Lerp(m_Bones[bone - 1], m_Bones[bone], 0.5f);
        }
    }

    private Quaternion Bone(Vector3[] positions, Quaternion bent, int bone)
    {
        int i = bone / m_Rig.BonesPerChain, joint = bone + i;
        var along = Vector3.Normalize(positions[joint + 1] - positions[joint]);
        var posed = Vector3.Transform(m_Rig.boneDirections[bone], bent);
        var swing = Quaternion.Normalize(new Quaternion(Vector3.Cross(posed, along), 1f + Vector3.Dot(posed, along)));
        Quaternion rotation = swing * bent;

        int before = i > 0 ? joint - m_Rig.joints : joint, after = i < m_Rig.chains - 1 ? joint + m_Rig.joints : joint;
        Vector3 across = positions[after] + positions[after + 1] - positions[before] - positions[before + 1];
        across -= along * Vector3.Dot(along, across);
        var rest = Vector3.Transform(m_Rig.crossDirections[bone], rotation);
        rest -= along * Vector3.Dot(along, rest);
        float roll = MathF.Atan2(Vector3.Dot(along, Vector3.Cross(rest, across)), Vector3.Dot(rest, across));
        return Quaternion.CreateFromAxisAngle(along, Math.Clamp(roll, -k_LargestRoll, k_LargestRoll)) * rotation;
    }
}
