using UnityEngine;

namespace Alate
{
    /// <summary>The colouring of a right wing as a function of the place on it, for vertex colours as well as for textures of any size.</summary>
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
            for (var vertex = 0; vertex < colours.Length; vertex++)
            {
                var position = surface.positions[vertex] / scale;
                colours[vertex] = ColourAt(position.x, position.z, softness);
            }

            return colours;
        }
    }
}
