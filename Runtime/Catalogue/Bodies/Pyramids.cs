using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Hairs and bristles: closed pyramids of four triangles, gathered to one part.</summary>
    internal sealed class Pyramids
    {
        private readonly List<Vector3> m_Positions = new List<Vector3>();
        private readonly List<Vector2> m_Uvs = new List<Vector2>();
        private readonly List<int> m_Triangles = new List<int>();

        /// <summary>Adds one pyramid.</summary>
        /// <param name="root">Middle of its base, millimetres.</param>
        /// <param name="along">From there to its point.</param>
        /// <param name="across">Any direction but that; tells where the corners of the base lie.</param>
        /// <param name="radius">Of the base, millimetres.</param>
        /// <param name="uv">Texture coordinates of all of it.</param>
        public void Add(Vector3 root, Vector3 along, Vector3 across, float radius, Vector2 uv)
        {
            var right = Vector3.Cross(along, across);
            right *= radius / right.magnitude;
            var up = Vector3.Cross(along, right);
            up *= radius / up.magnitude;
            int first = m_Positions.Count;
            for (int side = 0; side < 3; side++)
            {
                double angle = 2 * Math.PI * side / 3;
                m_Positions.Add(root + (float)Math.Cos(angle) * right + (float)Math.Sin(angle) * up);
                m_Triangles.AddRange(new[] { first + side, first + (side + 1) % 3, first + 3 });
            }

            m_Positions.Add(root + along);
            m_Triangles.AddRange(new[] { first, first + 2, first + 1 });
            m_Uvs.AddRange(new[] { uv, uv, uv, uv });
        }

        /// <summary>Joins all pyramids to one part.</summary>
        /// <param name="extent">Extent of what they stand on, millimetres.</param>
        public BodyPart ToPart(Vector2 extent) => BodyPart.Of(m_Positions.ToArray(), m_Uvs.ToArray(), m_Triangles.ToArray(), extent);
    }
}
