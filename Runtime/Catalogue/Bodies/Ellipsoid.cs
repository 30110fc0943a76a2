using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>An ellipsoid whose poles lie before and behind its centre: heads, eyes, knobs.</summary>
    internal static class Ellipsoid
    {
        /// <param name="centre">Millimetres.</param>
        /// <param name="radii">Right, up and ahead, millimetres.</param>
        /// <param name="rings">Pieces from pole to pole.</param>
        /// <param name="sides">Vertices of a ring, even.</param>
        public static BodyPart Around(Vector3 centre, Vector3 radii, int rings, int sides)
        {
            var sections = new CrossSection[rings + 1];
            for (int ring = 0; ring <= rings; ring++)
            {
                double angle = Math.PI * ring / rings;
                float across = ring == 0 || ring == rings ? 0f : (float)Math.Sin(angle);
                Vector3 middle = centre + new Vector3(0f, 0f, radii.z * (float)Math.Cos(angle));
                sections[ring] = new CrossSection(middle, radii.x * across, radii.y * across, radii.y * across);
            }

            return Tube.Along(sections, sides);
        }
    }
}
