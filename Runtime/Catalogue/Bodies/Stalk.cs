using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Thin round parts: antennae, palps and bristles along a cubic Bezier curve, legs along their joints.</summary>
    internal static class Stalk
    {
        /// <summary>Length of a leg's piece, as a share, over which it bends on either side of a joint.</summary>
        private const float k_Bend = 0.14f;

        /// <summary>Number of points of a bend.</summary>
        private const int k_BendPoints = 3;

        /// <summary>Length of the blunt ends over the whole.</summary>
        private const float k_End = 0.004f;

        /// <summary>A stalk along a cubic Bezier curve.</summary>
        /// <param name="curve">Beginning, two control points and end, millimetres.</param>
        /// <param name="radius">Millimetres at a place along the curve, 0 to 1; above 0.</param>
        /// <param name="rings">Pieces along the curve.</param>
        /// <param name="sides">Vertices of a ring, even.</param>
        public static BodyPart Along(Vector3[] curve, Func<float, float> radius, int rings, int sides)
        {
            var sections = new List<CrossSection> { CrossSection.Round(curve[0], 0f) };
            for (int ring = 0; ring <= rings; ring++)
            {
                float t = k_End + (1f - 2f * k_End) * ring / rings;
                sections.Add(CrossSection.Round(Bezier(curve, t), radius(t)));
            }

            sections.Add(CrossSection.Round(curve[3], 0f));
            return Tube.Along(sections, sides, Across(curve[0], curve[1]));
        }

        /// <summary>A leg through its joints, thinner from piece to piece, with rounded knees.</summary>
        /// <param name="joints">Millimetres, two or more.</param>
        /// <param name="radii">At each joint, millimetres, above 0.</param>
        /// <param name="sides">Vertices of a ring, even.</param>
        public static BodyPart Leg(Vector3[] joints, float[] radii, int sides)
        {
            int last = joints.Length - 1;
            var sections = new List<CrossSection>
            {
                CrossSection.Round(joints[0], 0f),
                CrossSection.Round(Vector3.Lerp(joints[0], joints[1], 0.01f), radii[0]),
            };
            for (int k = 1; k < last; k++)
            {
                var before = Vector3.Lerp(joints[k], joints[k - 1], k_Bend);
                var after = Vector3.Lerp(joints[k], joints[k + 1], k_Bend);
                for (int point = 0; point < k_BendPoints; point++)
                {
                    float t = point / (k_BendPoints - 1f);
                    var place = Vector3.Lerp(Vector3.Lerp(before, joints[k], t), Vector3.Lerp(joints[k], after, t), t);
                    sections.Add(CrossSection.Round(place, radii[k]));
                }
            }

            sections.Add(CrossSection.Round(Vector3.Lerp(joints[last], joints[last - 1], 0.05f), radii[last]));
            sections.Add(CrossSection.Round(joints[last], 0f));
            return Tube.Along(sections, sides, Across(joints[0], joints[1]));
        }

        /// <summary>A point of a cubic Bezier curve.</summary>
        public static Vector3 Bezier(Vector3[] curve, float t)
        {
            float s = 1f - t;
            return s * s * s * curve[0] + 3f * s * s * t * curve[1] + 3f * s * t * t * curve[2] + t * t * t * curve[3];
        }

        private static Vector3 Across(Vector3 from, Vector3 to)
        {
            Vector3 along = to - from;
            return Math.Abs(along.y) > 0.9f * along.magnitude ? new Vector3(0f, 0f, -1f) : new Vector3(0f, 1f, 0f);
        }
    }
}
