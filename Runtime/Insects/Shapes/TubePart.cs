using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>A part of a body: a tube of elliptic cross-sections along a spine, closed by a point where the radius is 0.</summary>
    sealed class TubePart
    {
        readonly Vector3[] m_Spine;
        readonly Vector2[] m_Radii;
        readonly int m_Sides;
        readonly Func<Vector3, Color32> m_Colour;

        /// <param name="spine">Centres of the cross-sections, millimetres.</param>
        /// <param name="radii">Half width and half height of each cross-section, millimetres; zero at both ends closes the tube.</param>
        /// <param name="sides">Vertices of a cross-section.</param>
        /// <param name="colour">The colour at a place, millimetres.</param>
        public TubePart(Vector3[] spine, Vector2[] radii, int sides, Func<Vector3, Color32> colour)
        {
            m_Spine = spine;
            m_Radii = radii;
            m_Sides = sides;
            m_Colour = colour;
        }

        /// <summary>An ellipsoid whose poles lie before and behind its centre.</summary>
        public static TubePart Ellipsoid(Vector3 centre, Vector3 radii, int rings, int sides, Func<Vector3, Color32> colour)
        {
            var spine = new Vector3[rings + 1];
            var sections = new Vector2[rings + 1];
            for (var ring = 0; ring <= rings; ring++)
            {
                var angle = Math.PI * ring / rings;
                var across = ring == 0 || ring == rings ? 0f : (float)Math.Sin(angle);
                spine[ring] = centre + new Vector3(0f, 0f, radii.z * (float)Math.Cos(angle));
                sections[ring] = new Vector2(radii.x * across, radii.y * across);
            }

            return new TubePart(spine, sections, sides, colour);
        }

        public void AppendTo(List<Vector3> positions, List<Color32> colours, List<int> triangles)
        {
            var direction = (m_Spine[m_Spine.Length - 1] - m_Spine[0]).normalized;
            var reference = Math.Abs(direction.y) > 0.9f ? new Vector3(0f, 0f, -1f) : new Vector3(0f, 1f, 0f);
            var previous = (Start: 0, Count: 0);
            for (var ring = 0; ring < m_Spine.Length; ring++)
            {
                var current = (Start: positions.Count, Count: m_Radii[ring].x == 0f ? 1 : m_Sides);
                AppendRing(ring, reference, current.Count, positions, colours);
                if (ring > 0)
                {
                    Bridge(previous, current, triangles);
                }

                previous = current;
            }
        }

        void AppendRing(int ring, Vector3 reference, int count, List<Vector3> positions, List<Color32> colours)
        {
            var before = m_Spine[Math.Max(ring - 1, 0)];
            var after = m_Spine[Math.Min(ring + 1, m_Spine.Length - 1)];
            var along = (after - before).normalized;
            var right = Vector3.Cross(along, reference).normalized;
            var up = Vector3.Cross(right, along);
            for (var side = 0; side < count; side++)
            {
                var angle = 2 * Math.PI * side / count;
                var position = m_Spine[ring]
                    + right * (m_Radii[ring].x * (float)Math.Cos(angle))
                    + up * (m_Radii[ring].y * (float)Math.Sin(angle));
                positions.Add(position);
                colours.Add(m_Colour(position));
            }
        }

        static void Bridge((int Start, int Count) from, (int Start, int Count) to, List<int> triangles)
        {
            var sides = Math.Max(from.Count, to.Count);
            for (var side = 0; side < sides; side++)
            {
                var next = (side + 1) % sides;
                if (from.Count > 1)
                {
                    AppendFacingOut(triangles, from.Start + side, from.Start + next, to.Start + (to.Count > 1 ? side : 0));
                }

                if (to.Count > 1)
                {
                    AppendFacingOut(triangles, from.Start + (from.Count > 1 ? next : 0), to.Start + next, to.Start + side);
                }
            }
        }

        static void AppendFacingOut(List<int> triangles, int a, int b, int c)
        {
            triangles.Add(a);
            triangles.Add(c);
            triangles.Add(b);
        }
    }
}
