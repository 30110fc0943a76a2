using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A slice across a part of a body, millimetres: two half ellipses, one above and one below the centre, bent up in the middle by an
    /// arch. Flat and arched it is a slice of a shell, thin and high one of a fin.
    /// </summary>
    internal readonly struct CrossSection
    {
        public CrossSection(Vector3 centre, float halfWidth, float above, float below, float arch = 0f)
        {
            Centre = centre;
            HalfWidth = halfWidth;
            Above = above;
            Below = below;
            Arch = arch;
        }

        public Vector3 Centre { get; }

        public float HalfWidth { get; }

        /// <summary>Height of the upper half.</summary>
        public float Above { get; }

        /// <summary>Depth of the lower half.</summary>
        public float Below { get; }

        /// <summary>Height of the middle over the rims, millimetres.</summary>
        public float Arch { get; }

        /// <summary>True where the slice is a single point, which closes the part.</summary>
        public bool IsPoint => HalfWidth <= 0f;

        /// <summary>Half of the way round the slice, about (Ramanujan's ellipse, the arch as a slope).</summary>
        public float HalfGirth
        {
            get
            {
                float height = 0.5f * (Above + Below);
                float sum = HalfWidth + height;
                return (float)(0.5 * Math.PI * (3 * sum - Math.Sqrt((3 * HalfWidth + height) * (HalfWidth + 3 * height))))
                    + 2f * Math.Abs(Arch);
            }
        }

        /// <summary>A round slice.</summary>
        public static CrossSection Round(Vector3 centre, float radius) => new CrossSection(centre, radius, radius, radius);

        /// <summary>Offset of a point of the rim from the centre, to the right and up, millimetres.</summary>
        /// <param name="sine">Of the angle from straight up, clockwise as seen from behind.</param>
        /// <param name="cosine">Of the same angle.</param>
        public Vector2 Rim(float sine, float cosine) =>
            new Vector2(HalfWidth * sine, (cosine > 0f ? Above : Below) * cosine + Arch * (1f - sine * sine));

        /// <summary>Slice that is wider and higher by a factor.</summary>
        public CrossSection Swollen(float factor) => new CrossSection(Centre, factor * HalfWidth, factor * Above, factor * Below, Arch);
    }
}
