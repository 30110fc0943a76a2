using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>A thin arched plate, such as a beetle's wing case or the shield over its head.</summary>
    internal static class Shell
    {
        /// <summary>A plate that is pointed, or rounded, at both ends.</summary>
        /// <param name="start">Where the plate begins, millimetres.</param>
        /// <param name="along">From its base to its end, millimetres.</param>
        /// <param name="up">Towards its bulging side.</param>
        /// <param name="halfWidth">Millimetres at a place along it, 0 to 1; 0 at both ends.</param>
        /// <param name="arch">Height of the middle over the rims, per half width.</param>
        /// <param name="thickness">Millimetres in the middle of the plate.</param>
        /// <param name="bow">How far the middle is raised over both ends, millimetres.</param>
        /// <param name="rings">Pieces along the plate.</param>
        /// <param name="sides">Vertices of a slice, both faces together, even.</param>
        public static BodyPart Along(
            Vector3 start, Vector3 along, Vector3 up, Func<float, float> halfWidth, float arch, float thickness, float bow,
            int rings, int sides)
        {
            Vector3 upright = Upright(up, along);
            var sections = new CrossSection[rings + 1];
            for (int ring = 0; ring <= rings; ring++)
            {
                float t = 0.5f - 0.5f * (float)Math.Cos(Math.PI * ring / rings);
                Vector3 centre = start + t * along + 4f * t * (1f - t) * bow * upright;
                float half = halfWidth(t);
                bool isEnd = ring == 0 || ring == rings;
                sections[ring] = isEnd
                    ? CrossSection.Round(centre, 0f)
                    : new CrossSection(centre, half, 0.5f * thickness, 0.5f * thickness, arch * half);
            }

            return Tube.Along(sections, sides, upright);
        }

        private static Vector3 Upright(Vector3 up, Vector3 along)
        {
            Vector3 across = up - along * (Vector3.Dot(up, along) / along.sqrMagnitude);
            return across / across.magnitude;
        }
    }
}
