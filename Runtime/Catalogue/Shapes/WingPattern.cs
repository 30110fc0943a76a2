using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>The colouring of a right wing as a function of the place on it, for vertex colours as well as for textures of any size.</summary>
    [MovedFrom(true, "Alate", "Alate")]
    public abstract class WingPattern
    {
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
        /// A picture of the wing for the texture coordinates of <see cref="WingMesher"/>, row by row from v = 0 as in a texture. What lies outside the outline is
        /// painted on, so that filtering at the edge finds no foreign colour.
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
            for (int pixel = 0; pixel < colours.Length; pixel++)
            {
                double u = (pixel % width + 0.5) / width;
                double v = (pixel / width + 0.5) / height;
                colours[pixel] = ColourAt(u, outline.Rear + v * (outline.Front - outline.Rear), softness);
            }

            return colours;
        }
    }
}
