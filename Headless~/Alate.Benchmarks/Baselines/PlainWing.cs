using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>
/// The whole model for one wing as one would write it at first: triangles, dense Newton, a skinned mesh in every substep.
/// </summary>
internal sealed class PlainWing
{
    private const int k_NewtonIterations = 4;
    private const float k_Tolerance = 1e-5f;

    private readonly PlainRig m_Rig;
    private readonly WingParameters m_Parameters;
    private readonly WingSurroundings m_Air;
    private readonly WingFrame m_Frame;
    private readonly PlainBeat m_Beat;
    private readonly PlainMotion m_Driven;
    private readonly PlainAerodynamics m_Aerodynamics;
    private readonly PlainBending m_Bending;
    private readonly PlainNewton m_Newton;
    private readonly PlainFrames m_Frames;
    private readonly PlainSurface m_Surface;

    private readonly Vector3[] m_Offsets;
    private readonly Vector3[] m_OffsetRates;
    private readonly Quaternion[] m_OldRotations;
    private readonly Vector3[] m_OldPositions;
    private readonly Vector3[] m_OldVelocities;
    private readonly PlainDualQuaternion[] m_Palette;

    /// <summary>The mesh as last skinned, in its own space.</summary>
    public readonly Vector3[] positions;
    public readonly Vector3[] normals;

    public PlainWing(PlainRig rig, Specimen specimen, in WingSurroundings air)
    {
        m_Rig = rig;
        m_Parameters = specimen.Parameters;
        m_Air = air;
        m_Frame = specimen.Rig.Frame;
        float beatRate = 2f * MathF.PI * m_Parameters.referenceFrequency;
        m_Beat = new PlainBeat(m_Parameters, air);
        m_Driven = new PlainMotion(rig, m_Parameters);
        m_Aerodynamics = new PlainAerodynamics(rig, m_Parameters);
        m_Bending = new PlainBending(rig, m_Parameters);
        m_Newton = new PlainNewton(rig, m_Parameters.elasticity * m_Parameters.springScale * beatRate * beatRate);
        m_Frames = new PlainFrames(rig);
        m_Surface = new PlainSurface(rig);
        m_Offsets = new Vector3[rig.JointCount];
        m_OffsetRates = new Vector3[rig.JointCount];
        m_Palette = new PlainDualQuaternion[rig.JointCount];
        positions = new Vector3[rig.vertices.Length];
        normals = new Vector3[rig.vertices.Length];

        m_Driven.Evaluate(m_Beat);
        m_Bending.Reset(m_Driven);
        Array.Copy(m_Driven.positions, m_Newton.positions, rig.JointCount);
        m_Frames.Evaluate(m_Newton.positions, m_Bending.rotations);
        m_Surface.Reset(m_Newton.positions, m_Frames.rotations);
        m_OldRotations = (Quaternion[])m_Driven.rotations.Clone();
        m_OldPositions = (Vector3[])m_Driven.positions.Clone();
        m_OldVelocities = (Vector3[])m_Driven.velocities.Clone();
    }

    /// <summary>Per joint, wing frame.</summary>
    public Vector3[] Joints => m_Newton.positions;

    /// <summary>Newton iterations since the start.</summary>
    public int Iterations { get; private set; }

    public void Substep(float h)
    {
        m_Beat.Advance(h);
        m_Driven.Evaluate(m_Beat);
        m_Surface.Carry(m_Driven, m_OldPositions, m_OldVelocities);
        m_Aerodynamics.Apply(m_Surface.carried, m_Surface.velocities, PlainRig.Plain(m_Air.wind));
        for (int joint = 0; joint < m_Rig.JointCount; joint++)
        {
            Vector3 own = PlainRig.Plain(m_Air.gravity) - m_Parameters.inertia * m_Driven.accelerations[joint];
            m_Aerodynamics.forces[joint] += m_Rig.masses[joint] * own;
        }

        m_Bending.Step(Joints, m_Aerodynamics.forces, m_Aerodynamics.damping, m_Driven, h);
        Stretch(h);
        m_Frames.Evaluate(Joints, m_Bending.rotations);
        m_Surface.Follow(Joints, m_Frames.rotations, h);
        Array.Copy(m_Driven.rotations, m_OldRotations, m_Rig.BoneCount);
        Array.Copy(m_Driven.positions, m_OldPositions, m_Rig.JointCount);
        Array.Copy(m_Driven.velocities, m_OldVelocities, m_Rig.JointCount);
    }

    /// <summary>The mesh by dual quaternions.</summary>
    public void Skin()
    {
        for (int joint = 0; joint < m_Palette.Length; joint++)
        {
            Quaternion real = m_Frames.rotations[joint];
            Vector3 moved = Joints[joint] - Vector3.Transform(m_Rig.restJoints[joint], real);
            Vector3 hinge = PlainRig.Plain(m_Frame.origin);
            Vector3 t = m_Frame.length * moved + hinge - Vector3.Transform(hinge, real);
            m_Palette[joint].real = real;
            m_Palette[joint].dual = new Quaternion(t, 0f) * real * 0.5f;
        }

        PlainSkinning.DualQuaternions(m_Rig.vertices, m_Palette, positions, normals);
    }

    // The implicit step on the deviation from the posed joints.
    private void Stretch(float h)
    {
        float beatRate = 2f * MathF.PI * m_Parameters.referenceFrequency;
        float anchorRate = m_Parameters.anchor * beatRate * MathF.Sqrt(m_Parameters.elasticity);
        float kept = MathF.Exp(-2f * m_Parameters.springDamping * anchorRate * h);
        float stiffness = 1f / (h * h) + anchorRate * anchorRate;
        for (int joint = 0; joint < m_Rig.JointCount; joint++)
        {
            int i = joint / m_Rig.joints, bone = Math.Min(joint - i, (i + 1) * m_Rig.BonesPerChain - 1);
            Quaternion turned = m_Driven.rotations[bone] * Quaternion.Conjugate(m_OldRotations[bone]);
            m_Offsets[joint] = Vector3.Transform(m_Offsets[joint], turned);
            Vector3 predicted = m_Offsets[joint] + kept * h * Vector3.Transform(m_OffsetRates[joint], turned);
            m_Newton.positions[joint] = m_Bending.targets[joint] + m_Offsets[joint];
            m_Newton.anchors[joint] = m_Bending.targets[joint] + predicted / (h * h * stiffness);
            m_Newton.inertia[joint] = m_Rig.masses[joint] * stiffness;
        }

        Iterations += m_Newton.Minimise(k_NewtonIterations, k_Tolerance);
        for (int joint = 0; joint < m_Rig.JointCount; joint++)
        {
            Vector3 offset = m_Newton.positions[joint] - m_Bending.targets[joint];
            m_OffsetRates[joint] = (offset - m_Offsets[joint]) / h;
            m_Offsets[joint] = offset;
        }
    }
}
