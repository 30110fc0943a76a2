using System;
using System.Numerics;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>Eq. 1–3 and the driven pose of one wing, joint by joint along its chains.</summary>
internal sealed class PlainMotion
{
    private readonly PlainRig m_Rig;
    private readonly WingParameters m_Parameters;

    public readonly Quaternion[] rotations;
    public readonly Vector3[] positions;
    public readonly Vector3[] velocities;
    public readonly Vector3[] accelerations;

    // Flap, sweep, feather summed along the chain, and their derivatives.
    private Vector3 m_Angle;
    private Vector3 m_Rate;
    private Vector3 m_Curvature;
    private Vector3 m_AngularVelocity;
    private Vector3 m_AngularAcceleration;

    public PlainMotion(PlainRig rig, in WingParameters parameters)
    {
        m_Rig = rig;
        m_Parameters = parameters;
        rotations = new Quaternion[rig.BoneCount];
        positions = new Vector3[rig.JointCount];
        velocities = new Vector3[rig.JointCount];
        accelerations = new Vector3[rig.JointCount];
    }

    public void Evaluate(PlainBeat beat)
    {
        Quaternion baseRotation = default;
        Vector3 baseVelocity = default, baseAcceleration = default;
        for (int i = 0; i < m_Rig.chains; i++)
        {
            m_Angle = new Vector3(m_Parameters.meanFlap, 0f, 0f);
            m_Rate = m_Curvature = default;
            for (int j = 0; j < m_Rig.BonesPerChain; j++)
            {
                int bone = i * m_Rig.BonesPerChain + j;
                AddWave(beat, i, j);
                Turn(beat.rate, bone);
                if (bone == 0)
                    (baseRotation, baseVelocity, baseAcceleration) = (rotations[0], m_AngularVelocity, m_AngularAcceleration);
                int joint = bone + i;
                if (j == 0)
                {
                    positions[joint] = Vector3.Transform(m_Rig.restJoints[joint], baseRotation);
                    velocities[joint] = Vector3.Cross(baseVelocity, positions[joint]);
                    accelerations[joint] = Vector3.Cross(baseAcceleration, positions[joint]);
                }

                var arm = Vector3.Transform(m_Rig.bones[bone], rotations[bone]);
                positions[joint + 1] = positions[joint] + arm;
                velocities[joint + 1] = velocities[joint] + Vector3.Cross(m_AngularVelocity, arm);
                accelerations[joint + 1] = accelerations[joint] + Vector3.Cross(m_AngularAcceleration, arm);
            }
        }
    }

    private void AddWave(PlainBeat beat, int i, int j)
    {
        float p = beat.phase - MathF.PI * (m_Parameters.chordDelay * m_Rig.chainRatio[i] + m_Parameters.spanDelay * m_Rig.jointRatio[j]);
        int cycle = 0;
        for (; p < 0f && cycle < Math.Min(beat.cycles, 3); cycle++)
            p += 2f * MathF.PI;
        bool moving = p >= 0f;
        p = MathF.Max(p, 0f);

        float x = MathF.Min(p / MathF.PI, 1f);
        Vector3 rise = beat.amplitudes[cycle] - beat.amplitudes[cycle + 1];
        Vector3 amplitude = beat.amplitudes[cycle + 1] + rise * (x * x * (3f - 2f * x));
        Vector3 rate = rise * (6f / MathF.PI * x * (1f - x));
        Vector3 curvature = p > 0f && p < MathF.PI ? rise * ((6f - 12f * x) / (MathF.PI * MathF.PI)) : default;

        float3 phase = m_Parameters.phase;
        var cos = new Vector3(MathF.Cos(p + phase.x), MathF.Cos(p + phase.y), MathF.Cos(p + phase.z));
        var sin = new Vector3(MathF.Sin(p + phase.x), MathF.Sin(p + phase.y), MathF.Sin(p + phase.z));
        float share = j == 0 ? m_Parameters.rootShare : (1f - m_Parameters.rootShare) / (m_Rig.BonesPerChain - 1);
        m_Angle += share * amplitude * cos;
        if (!moving)
            return;
        m_Rate += share * (rate * cos - amplitude * sin);
        m_Curvature += share * (curvature * cos - 2f * rate * sin - amplitude * cos);
    }

    private void Turn(float phaseRate, int bone)
    {
        var tilt = Quaternion.CreateFromAxisAngle(Vector3.UnitX, -m_Parameters.tilt);
        Quaternion flapped = tilt * Quaternion.CreateFromAxisAngle(Vector3.UnitZ, m_Angle.X);
        Quaternion swept = flapped * Quaternion.CreateFromAxisAngle(-Vector3.UnitY, m_Angle.Y);
        rotations[bone] = swept * Quaternion.CreateFromAxisAngle(m_Rig.leadingEdge, m_Angle.Z);

        var flapAxis = Vector3.Transform(Vector3.UnitZ, tilt);
        var sweepAxis = Vector3.Transform(-Vector3.UnitY, flapped);
        var featherAxis = Vector3.Transform(m_Rig.leadingEdge, swept);
        m_AngularVelocity = phaseRate * (flapAxis * m_Rate.X + sweepAxis * m_Rate.Y + featherAxis * m_Rate.Z);
        m_AngularAcceleration =
            phaseRate * phaseRate * (flapAxis * m_Curvature.X + sweepAxis * m_Curvature.Y + featherAxis * m_Curvature.Z);
    }
}
