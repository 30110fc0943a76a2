using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Joins cross-sections along a spine to a closed part; the first and the last are points.</summary>
    internal static class Tube
    {
        private static readonly Vector3 s_Up = new Vector3(0f, 1f, 0f);

        /// <summary>A tube whose sections stand upright at its beginning and turn as little as they can on their way.</summary>
        /// <param name="sections">Two or more.</param>
        /// <param name="sides">Vertices of a section, even, so that the upper and the lower line have vertices.</param>
        public static BodyPart Along(IReadOnlyList<CrossSection> sections, int sides) => Along(sections, sides, s_Up);

        /// <param name="sections">Two or more.</param>
        /// <param name="sides">Vertices of a section, even.</param>
        /// <param name="up">Up in the first section, not along the spine.</param>
        public static BodyPart Along(IReadOnlyList<CrossSection> sections, int sides, Vector3 up)
        {
            var positions = new List<Vector3>();
            var uvs = new List<Vector2>();
            var triangles = new List<int>();
            float[] lengths = Lengths(sections);
            float girth = 0f;
            (int start, int count) previous = default;
            for (int k = 0; k < sections.Count; k++)
            {
                (int start, int count) ring = (positions.Count, sections[k].IsPoint ? 1 : sides);
                up = Upright(up, Direction(sections, k));
                AppendRing(sections[k], ring.count, Vector3.Cross(up, Direction(sections, k)), up, positions);
                for (int side = 0; side < ring.count; side++)
                {
                    float u = ring.count == 1 ? 0.5f : 2f * Math.Min(side, ring.count - side) / ring.count;
                    uvs.Add(new Vector2(u, lengths[k] / lengths[lengths.Length - 1]));
                }

                if (k > 0)
                    Bridge(previous, ring, triangles);
                previous = ring;
                girth = Math.Max(girth, sections[k].HalfGirth);
            }

            return BodyPart.Of(positions.ToArray(), uvs.ToArray(), triangles.ToArray(), new Vector2(girth, lengths[lengths.Length - 1]));
        }

        private static float[] Lengths(IReadOnlyList<CrossSection> sections)
        {
            float[] lengths = new float[sections.Count];
            for (int k = 1; k < lengths.Length; k++)
                lengths[k] = lengths[k - 1] + (sections[k].Centre - sections[k - 1].Centre).magnitude;
            return lengths;
        }

        private static Vector3 Direction(IReadOnlyList<CrossSection> sections, int k)
        {
            Vector3 before = sections[Math.Max(k - 1, 0)].Centre;
            Vector3 after = sections[Math.Min(k + 1, sections.Count - 1)].Centre;
            return (after - before) / (after - before).magnitude;
        }

        private static Vector3 Upright(Vector3 up, Vector3 along)
        {
            Vector3 across = up - along * Vector3.Dot(up, along);
            return across / across.magnitude;
        }

        // Sines and cosines are taken from one quarter, so that both halves of a section are mirror images to the last bit.
        private static void AppendRing(in CrossSection section, int count, Vector3 right, Vector3 up, List<Vector3> positions)
        {
            if (count == 1)
            {
                positions.Add(section.Centre);
                return;
            }

            for (int side = 0; side < count; side++)
            {
                bool isMirrored = 2 * side > count;
                double angle = 2 * Math.PI * (isMirrored ? count - side : side) / count;
                Vector2 rim = section.Rim(2 * side == count ? 0f : (float)Math.Sin(angle), (float)Math.Cos(angle));
                positions.Add(section.Centre + right * (isMirrored ? -rim.x : rim.x) + up * rim.y);
            }
        }

        // The diagonals of one half are the mirror images of those of the other.
        private static void Bridge((int start, int count) from, (int start, int count) to, List<int> triangles)
        {
            int sides = Math.Max(from.count, to.count);
            for (int side = 0; side < sides; side++)
            {
                int next = (side + 1) % sides;
                if (from.count == 1)
                {
                    Append(triangles, from.start, to.start + next, to.start + side);
                }
                else if (to.count == 1)
                {
                    Append(triangles, from.start + side, from.start + next, to.start);
                }
                else if (2 * side < sides)
                {
                    Append(triangles, from.start + side, from.start + next, to.start + side);
                    Append(triangles, from.start + next, to.start + next, to.start + side);
                }
                else
                {
                    Append(triangles, from.start + side, from.start + next, to.start + next);
                    Append(triangles, from.start + side, to.start + next, to.start + side);
                }
            }
        }

        private static void Append(List<int> triangles, int a, int b, int c)
        {
            triangles.Add(a);
            triangles.Add(b);
            triangles.Add(c);
        }
    }
}
