using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>Eq. 4 and the damped hinges of one wing: torques, three implicit steps a bone, and the posed joints that follow.</summary>
internal sealed class PlainBending
{
    private readonly PlainRig m_Rig;
    private readonly WingParameters m_Parameters;
    private readonly float[] m_Stiffness;
    private readonly Vector3[] m_Angles;
    private readonly Vector3[] m_Rates;

    /// <summary>Per bone: driven and bent.</summary>
    public readonly Quaternion[] rotations;

    /// <summary>Per joint.</summary>
    public readonly Vector3[] targets;

    public PlainBending(PlainRig rig, in WingParameters parameters)
    {
        m_Rig = rig;
        m_Parameters = parameters;
        m_Stiffness = new float[rig.BoneCount];
        m_Angles = new Vector3[rig.BoneCount];
        m_Rates = new Vector3[rig.BoneCount];
        rotations = new Quaternion[rig.BoneCount];
        targets = new Vector3[rig.JointCount];
        float beat = 2f * MathF.PI * parameters.referenceFrequency;
        for (int bone = 0; bone < rig.BoneCount; bone++)
        {
            int i = bone / rig.BonesPerChain, j = bone % rig.BonesPerChain;
            float factor = parameters.stiffnessRoot * MathF.Pow(parameters.stiffnessTip / parameters.stiffnessRoot, rig.chainRatio[i]);
            m_Stiffness[bone] = parameters.elasticity * beat * beat * factor * factor * rig.inertias[i * rig.BonesPerChain]
                * MathF.Exp(-rig.jointRatio[j] / parameters.stiffnessDecay);
        }
    }

    public void Step(Vector3[] joints, Vector3[] forces, float[] airDamping, PlainMotion driven, float h)
    {
        for (int bone = 0; bone < m_Stiffness.Length; bone++)
        {
            int i = bone / m_Rig.BonesPerChain, joint = bone + i, end = (i + 1) * m_Rig.joints;
            Vector3 torque = default;
            float damping = 0f;
            for (int k = joint + 1; k < end; k++)
            {
                torque += Vector3.Cross(joints[k] - joints[joint], forces[k]);
                damping += airDamping[k] * m_Rig.leverDamping[joint * m_Rig.joints + k % m_Rig.joints];
            }

            Turn(bone, Vector3.Transform(torque, Quaternion.Conjugate(rotations[bone])), damping, h);
        }

        Pose(driven);
    }

    /// <summary>Starts in the driven pose.</summary>
    public void Reset(PlainMotion driven) => Pose(driven);

    private void Turn(int bone, Vector3 torque, float airDamping, float h)
    {
        Vector3 angles = m_Angles[bone], rates = m_Rates[bone];
        float bend = m_Stiffness[bone] * (angles.X > 0f ? m_Parameters.dorsalAsymmetry : 1f);
        float inPlane = m_Stiffness[bone] * m_Parameters.inPlaneFactor;
        float torsion = m_Stiffness[bone] * m_Parameters.torsionFactor;
        Hinge(bone, Vector3.Dot(torque, m_Rig.bendAxes[bone]), airDamping, bend, h, ref angles.X, ref rates.X);
        Hinge(bone, torque.Y, airDamping, inPlane, h, ref angles.Y, ref rates.Y);
        Hinge(bone, Vector3.Dot(torque, m_Rig.boneDirections[bone]), 0f, torsion, h, ref angles.Z, ref rates.Z);
        m_Angles[bone] = angles;
        m_Rates[bone] = rates;
    }

    private void Hinge(int bone, float torque, float airDamping, float stiffness, float h, ref float angle, ref float rate)
    {
        float inertia = m_Rig.inertias[bone];
        float damping = 2f * m_Parameters.bendDamping * MathF.Sqrt(stiffness * inertia);
        rate = ((inertia + airDamping * h) * rate + h * (torque - stiffness * angle))
            / (inertia + (damping + airDamping) * h + stiffness * h * h);
        float moved = angle + rate * h;
        angle = Math.Clamp(moved, -m_Parameters.jointLimit, m_Parameters.jointLimit);
        if (angle != moved)
            rate = 0f;
    }

    private void Pose(PlainMotion driven)
    {
        for (int i = 0; i < m_Rig.chains; i++)
        {
            targets[i * m_Rig.joints] = driven.positions[i * m_Rig.joints];
            for (int j = 0; j < m_Rig.BonesPerChain; j++)
            {
                int bone = i * m_Rig.BonesPerChain + j;
                Quaternion turn = j == 0
                    ? driven.rotations[bone]
                    : rotations[bone - 1] * (Quaternion.Conjugate(driven.rotations[bone - 1]) * driven.rotations[bone]);
                Vector3 angles = m_Angles[bone];
                Vector3 axis = angles.X * m_Rig.bendAxes[bone] + angles.Y * Vector3.UnitY + angles.Z * m_Rig.boneDirections[bone];
                float angle = axis.Length();
                if (angle > 1e-8f)
                    turn *= Quaternion.CreateFromAxisAngle(axis / angle, angle);
                rotations[bone] = Quaternion.Normalize(turn);
                targets[bone + i + 1] = targets[bone + i] + Vector3.Transform(m_Rig.bones[bone], rotations[bone]);
            }
        }
    }
}
