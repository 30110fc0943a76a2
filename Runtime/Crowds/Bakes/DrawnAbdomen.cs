using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>Vertices of an insect that an <see cref="AbdomenSwing"/> moves.</summary>
    internal readonly struct DrawnAbdomen
    {
        private readonly string m_Name;
        private readonly float3 m_Hinge, m_Axis;
        private readonly float m_Swing, m_Lowest;
        private readonly int m_Start, m_Count;

        /// <param name="swing">The component.</param>
        /// <param name="own">Its axes in the insect.</param>
        /// <param name="parent">Those of its parent, about whose X axis it turns.</param>
        /// <param name="start">First vertex in the surface of the insect.</param>
        /// <param name="count">Number of vertices.</param>
        public DrawnAbdomen(AbdomenSwing swing, in Matrix4x4 own, in Matrix4x4 parent, int start, int count)
        {
            m_Name = swing.name;
            m_Hinge = own.MultiplyPoint3x4(Vector3.zero);
            m_Axis = parent.MultiplyVector(Vector3.right).normalized;
            m_Swing = math.radians(swing.Swing);
            m_Lowest = math.radians(swing.LowestPhase);
            m_Start = start;
            m_Count = count;
        }

        /// <summary>Describes it for writers of files.</summary>
        /// <param name="joint">Its joint among those of a frame.</param>
        public BakedAbdomen Describe(int joint) => new BakedAbdomen
        {
            Name = m_Name,
            FirstVertex = m_Start,
            VertexCount = m_Count,
            Joint = joint,
            Hinge = m_Hinge,
        };

        /// <summary>Turns the vertices and the joint of a frame.</summary>
        /// <param name="frame">With the insect at rest.</param>
        /// <param name="joint">Its joint among those of the frame.</param>
        /// <param name="phase">Of the first wing's beat, radians.</param>
        /// <param name="share">Of the swing.</param>
        public void Pose(BakedFrame frame, int joint, float phase, float share)
        {
            quaternion turn = BodyMotion.Turn(BodyAbdomen.AngleAt(share * m_Swing, m_Lowest, phase) * m_Axis);
            for (int vertex = m_Start; vertex < m_Start + m_Count; vertex++)
            {
                frame.Positions[vertex] = m_Hinge + math.rotate(turn, frame.Positions[vertex] - m_Hinge);
                frame.Normals[vertex] = math.rotate(turn, frame.Normals[vertex]);
            }

            frame.Joints[joint] = new BakedJoint(m_Hinge, turn);
        }
    }
}
