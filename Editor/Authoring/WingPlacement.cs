using System;
using Alate.Geometry;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>Placement of a wing's mesh in the picture from which it was traced: turned, scaled and moved, never mirrored.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public readonly struct WingPlacement
    {
        private readonly PlanPoint m_Hinge;
        private readonly PlanPoint m_Axis;
        private readonly double m_Scale;
        private readonly int m_Width;
        private readonly int m_Height;

        /// <param name="picture">The picture.</param>
        /// <param name="hinge">Origin of the mesh; pixels, z up.</param>
        /// <param name="axis">The mesh's X axis, a unit vector; z up.</param>
        /// <param name="scale">Mesh units of a pixel.</param>
        internal WingPlacement(WingPicture picture, PlanPoint hinge, PlanPoint axis, double scale)
        {
            m_Hinge = hinge;
            m_Axis = axis;
            m_Scale = scale;
            m_Width = picture.Width;
            m_Height = picture.Height;
        }

        /// <summary>Mesh units of a pixel.</summary>
        public float UnitsPerPixel => (float)m_Scale;

        /// <summary>Converts a point of the mesh to the picture: pixels from its top left corner, y down.</summary>
        public Vector2 ToPicture(Vector3 point)
        {
            PlanPoint place = m_Hinge + m_Axis * (point.x / m_Scale) + new PlanPoint(-m_Axis.z, m_Axis.x) * (point.z / m_Scale);
            return new Vector2((float)place.x, (float)-place.z);
        }

        internal Vector3 ToMesh(PlanPoint place)
        {
            PlanPoint from = place - m_Hinge;
            return new Vector3((float)(m_Scale * PlanPoint.Dot(from, m_Axis)), 0f, (float)(m_Scale * PlanPoint.Cross(m_Axis, from)));
        }

        internal Vector2 ToTexture(PlanPoint place) =>
            new Vector2(
                (float)Math.Min(1.0, Math.Max(0.0, place.x / m_Width)), (float)Math.Min(1.0, Math.Max(0.0, 1.0 + place.z / m_Height)));
    }
}
