using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>An outline of <see cref="InsectOutlines"/> as a flat mesh, turned about its hinge at the origin and mirrored.</summary>
    internal sealed class DrawnInsectWing
    {
        private const int k_Triangles = 600;

        private readonly Vector2[] m_Outline;
        private readonly float m_Degrees;
        private readonly bool m_IsMirrored;

        /// <param name="outline">Counterclockwise, the hinge at its origin.</param>
        /// <param name="degrees">From +X to the way to the tip, counterclockwise seen from above with +Z ahead.</param>
        /// <param name="isMirrored">Whether the edge towards +y of the outline lies on the other side.</param>
        public DrawnInsectWing(Vector2[] outline, float degrees, bool isMirrored)
        {
            m_Outline = outline;
            m_Degrees = degrees;
            m_IsMirrored = isMirrored;
        }

        /// <summary>The direction from the trailing to the leading edge.</summary>
        public Vector3 Leading => Place(new Vector2(0f, 1f));

        /// <summary>The outline, counterclockwise.</summary>
        public PlanPoint[] Plan
        {
            get
            {
                Vector2[] turned = Array.ConvertAll(m_Outline, Turned);
                if (m_IsMirrored)
                    Array.Reverse(turned);
                return Array.ConvertAll(turned, p => new PlanPoint(p.x, p.y));
            }
        }

        public SurfaceMesh Surface
        {
            get
            {
                TriangleLinks mesh = OutlineMesher.Mesh(Plan, k_Triangles, out _);
                return new SurfaceMesh
                {
                    name = "drawn wing",
                    positions = Array.ConvertAll(mesh.points, p => new Vector3((float)p.x, 0f, (float)p.z)),
                    triangles = mesh.Clockwise(),
                };
            }
        }

        /// <summary>Returns true where a skeleton's first chain lies before its last.</summary>
        public bool Leads(WingSkeleton skeleton)
        {
            int joint = skeleton.JointsPerChain / 2;
            return Vector3.Dot(skeleton.GetJoint(0, joint) - skeleton.GetJoint(skeleton.ChainCount - 1, joint), Leading) > 0f;
        }

        private Vector3 Place(Vector2 p)
        {
            Vector2 turned = Turned(p);
            return new Vector3(turned.x, 0f, turned.y);
        }

        private Vector2 Turned(Vector2 p)
        {
            float y = m_IsMirrored ? -p.y : p.y, turn = m_Degrees * Mathf.Deg2Rad;
            return new Vector2(Mathf.Cos(turn) * p.x - Mathf.Sin(turn) * y, Mathf.Sin(turn) * p.x + Mathf.Cos(turn) * y);
        }
    }
}
