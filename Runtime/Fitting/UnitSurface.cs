using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Fitting
{
    /// <summary>
    /// Vertices of a wing moved and scaled so that their bounding box is 1 long and lies about the origin: tolerances then have one meaning
    /// for a wing of millimetres near the origin and for one of kilometres far from it.
    /// </summary>
    internal sealed class UnitSurface
    {
        /// <summary>[vertex] Position, in unit space.</summary>
        public readonly float3[] points;

        /// <summary>Three vertex indices a triangle.</summary>
        public readonly int[] triangles;

        private readonly double m_X;
        private readonly double m_Y;
        private readonly double m_Z;
        private readonly double m_Size;

        /// <param name="surface">A checked one; only vertices of triangles count.</param>
        /// <exception cref="ArgumentException">All vertices lie in one place.</exception>
        public UnitSurface(SurfaceMesh surface)
        {
            float3 low = float.MaxValue, high = float.MinValue;
            foreach (int index in surface.triangles)
            {
                low = math.min(low, surface.positions[index]);
                high = math.max(high, surface.positions[index]);
            }

            m_X = 0.5 * ((double)low.x + high.x);
            m_Y = 0.5 * ((double)low.y + high.y);
            m_Z = 0.5 * ((double)low.z + high.z);
            m_Size = Math.Max((double)high.x - low.x, Math.Max((double)high.y - low.y, (double)high.z - low.z));
            if (!(m_Size > 0.0))
                throw new ArgumentException($"{SurfaceCheck.Name(surface)} has no triangle with an area.");
            triangles = surface.triangles;
            points = Array.ConvertAll(surface.positions, ToUnit);
        }

        /// <summary>Converts a place of mesh space to unit space.</summary>
        public float3 ToUnit(Vector3 p) =>
            new float3((float)((p.x - m_X) / m_Size), (float)((p.y - m_Y) / m_Size), (float)((p.z - m_Z) / m_Size));

        /// <summary>Converts a place of unit space to mesh space.</summary>
        public Vector3 ToMesh(float3 p) =>
            new Vector3((float)(m_X + m_Size * p.x), (float)(m_Y + m_Size * p.y), (float)(m_Z + m_Size * p.z));
    }
}
