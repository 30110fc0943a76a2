using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// The colouring of a right wing as a function of the place on it, for vertex colours as well as for textures of any size.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public abstract class WingPattern
    {
        /// <summary>Reach of the pattern beyond the outline, pixels: for filtering and small mipmaps.</summary>
        private const int k_Bleed = 8;

        /// <summary>Underside that looks as the upper side does.</summary>
        internal static readonly Color NoUnderside = new Color(1f, 1f, 1f, 0f);

        /// <summary>
        /// Colour towards which the lower side is paler than the upper one: as far as its alpha says where the pattern is bright, not at
        /// all where it is black. Alpha 0 is no difference.
        /// </summary>
        public virtual Color Underside => NoUnderside;

        /// <summary>The colour at a place on the wing.</summary>
        /// <param name="span">Distance from the base along the span, wing lengths, 0 to 1.</param>
        /// <param name="forward">Distance ahead of the hinge line, wing lengths.</param>
        /// <param name="softness">Width over which one colour turns into the next, wing lengths: about the distance of two samples.</param>
        public abstract Color ColourAt(double span, double forward, double softness);

        /// <summary>One colour for each vertex of a mesh that was made with the given length of the wing.</summary>
        public Color32[] ColourVertices(SurfaceMesh surface, float scale, double softness)
        {
            var colours = new Color32[surface.VertexCount];
            for (int vertex = 0; vertex < colours.Length; vertex++)
            {
                Vector3 position = surface.positions[vertex] / scale;
                colours[vertex] = ColourAt(position.x, position.z, softness);
            }

            return colours;
        }

        /// <summary>
        /// A picture of the wing for the texture coordinates of <see cref="WingMesher"/>, row by row from v = 0 as in a texture. The
        /// colours near the edge go on outside the outline, so that filtering finds no foreign colour.
        /// </summary>
        /// <param name="outline">The outline that was meshed.</param>
        /// <param name="width">Columns, 1 or more.</param>
        /// <param name="height">Rows, 1 or more.</param>
        public Color32[] Paint(WingOutline outline, int width, int height)
        {
            if (width < 1 || height < 1)
            {
                throw new ArgumentOutOfRangeException(
                    width < 1 ? nameof(width) : nameof(height), Math.Min(width, height), "A picture has one row and one column or more.");
            }

            var colours = new Color32[width * height];
            double softness = Math.Max(1.0 / width, (outline.Front - outline.Rear) / height);
            double perRow = (outline.Front - outline.Rear) / height;
            for (int column = 0; column < width; column++)
            {
                double span = (column + 0.5) / width;
                int first = Math.Clamp((int)((outline.TrailingAt(span) - outline.Rear) / perRow) - k_Bleed, 0, height - 1);
                int last = Math.Clamp((int)((outline.LeadingAt(span) - outline.Rear) / perRow) + k_Bleed, first, height - 1);
                for (int row = first; row <= last; row++)
                    colours[row * width + column] = ColourAt(span, outline.Rear + (row + 0.5) * perRow, softness);
                for (int row = 0; row < height; row++)
                    colours[row * width + column] = colours[Math.Clamp(row, first, last) * width + column];
            }

            return colours;
        }
    }
}
