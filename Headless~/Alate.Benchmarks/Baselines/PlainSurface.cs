using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>
/// The vertices that meet the air: where they were after the last substep, how fast, and carried on with the driven pose.
/// </summary>
internal sealed class PlainSurface
{
    private readonly PlainRig m_Rig;
    private readonly Matrix4x4[] m_Palette;
    private readonly Vector3[] m_Current;
    private readonly Vector3[] m_Previous;
    private readonly Vector3[] m_OwnVelocities;

    public readonly Vector3[] carried;
    public readonly Vector3[] velocities;

    public PlainSurface(PlainRig rig)
    {
        m_Rig = rig;
        m_Palette = new Matrix4x4[rig.JointCount];
        m_Current = new Vector3[rig.vertices.Length];
        m_Previous = new Vector3[rig.vertices.Length];
        m_OwnVelocities = new Vector3[rig.vertices.Length];
        carried = new Vector3[rig.vertices.Length];
        velocities = new Vector3[rig.vertices.Length];
    }

    public void Reset(Vector3[] joints, Quaternion[] rotations)
    {
        Skin(joints, rotations);
        Array.Clear(m_OwnVelocities);
    }

    /// <summary>Follows the joints after a substep.</summary>
    public void Follow(Vector3[] joints, Quaternion[] rotations, float h)
    {
        Array.Copy(m_Current, m_Previous, m_Current.Length);
        Skin(joints, rotations);
        for (int v = 0; v < m_Current.Length; v++)
            m_OwnVelocities[v] = (m_Current[v] - m_Previous[v]) / h;
    }

    /// <summary>Moves the surface, before the next substep, as the driven pose has moved since.</summary>
    public void Carry(PlainMotion driven, Vector3[] oldPositions, Vector3[] oldVelocities)
    {
        for (int v = 0; v < m_Current.Length; v++)
        {
            ref readonly PlainVertex vertex = ref m_Rig.vertices[v];
            carried[v] = m_Current[v];
            velocities[v] = m_OwnVelocities[v];
            for (int k = 0; k < 4; k++)
            {
                int joint = vertex.joints[k];
                carried[v] += vertex.weights[k] * (driven.positions[joint] - oldPositions[joint]);
                velocities[v] += vertex.weights[k] * (driven.velocities[joint] - oldVelocities[joint]);
            }
        }
    }

    private void Skin(Vector3[] joints, Quaternion[] rotations)
    {
        for (int joint = 0; joint < m_Palette.Length; joint++)
        {
            m_Palette[joint] = Matrix4x4.CreateFromQuaternion(rotations[joint]);
            m_Palette[joint].Translation = joints[joint] - Vector3.Transform(m_Rig.restJoints[joint], rotations[joint]);
        }

        PlainSkinning.Positions(m_Rig.vertices, m_Palette, m_Current);
    }
}
