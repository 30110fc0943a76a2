using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Margin of a wing in its picture: a smooth curve just inside the rim of the mesh, whose corners would else be seen from near by.
    /// Beyond it the picture is clear.
    /// </summary>
    internal sealed class MarginCut
    {
        /// <summary>Lines in a row of pixels along which it is measured what share of each pixel lies within.</summary>
        private const int k_LinesOfARow = 8;

        private readonly PolygonGrid m_Inside;

        /// <summary>Finds the margin of a right wing.</summary>
        /// <param name="surface">The flat mesh.</param>
        /// <param name="scale">Mesh units of one wing length.</param>
        public MarginCut(SurfaceMesh surface, float scale)
        {
            PlanPoint[] rim = Array.ConvertAll(
                Longest(MeshRim.Of(surface.triangles)),
                vertex => new PlanPoint(surface.positions[vertex].x / scale, surface.positions[vertex].z / scale));
            if (Polygon.Area(rim) < 0.0)
                Array.Reverse(rim);
            Curve = InnerCurve.Of(rim);
            m_Inside = new PolygonGrid(Curve);
        }

        /// <summary>Points of the curve, wing lengths, counterclockwise.</summary>
        public PlanPoint[] Curve { get; }

        /// <summary>Returns true for places on the wing.</summary>
        /// <param name="span">Distance from the base along the span, wing lengths.</param>
        /// <param name="forward">Distance ahead of the hinge line, wing lengths.</param>
        public bool Contains(double span, double forward) => m_Inside.Contains(new PlanPoint(span, forward));

        /// <summary>Lessens the opacity of pixels by the share of them that lies beyond the margin.</summary>
        /// <param name="pixels">Picture for the texture coordinates of <see cref="WingMesher"/>, row by row from v = 0.</param>
        /// <param name="width">Columns.</param>
        /// <param name="outline">Outline of the wing, whose bounds the picture has.</param>
        public void Apply(Color32[] pixels, int width, WingOutline outline)
        {
            int height = pixels.Length / width;
            double perRow = (outline.Front - outline.Rear) / height;
            double[] within = new double[width];
            var crossings = new List<double>();
            for (int row = 0; row < height; row++)
            {
                Array.Clear(within, 0, width);
                for (int line = 0; line < k_LinesOfARow; line++)
                {
                    m_Inside.FindCrossings(outline.Rear + (row + (line + 0.5) / k_LinesOfARow) * perRow, crossings);
                    for (int k = 0; k + 1 < crossings.Count; k += 2)
                        Add(within, crossings[k] * width, crossings[k + 1] * width);
                }

                for (int column = 0; column < width; column++)
                {
                    ref Color32 pixel = ref pixels[row * width + column];
                    pixel.a = (byte)Math.Round(pixel.a * Math.Min(within[column] / k_LinesOfARow, 1.0));
                }
            }
        }

        // A stretch of a line, pixels.
        private static void Add(double[] within, double from, double to)
        {
            int first = Math.Max((int)Math.Floor(from), 0), last = Math.Min((int)Math.Ceiling(to), within.Length);
            for (int column = first; column < last; column++)
                within[column] += Math.Max(Math.Min(to, column + 1.0) - Math.Max(from, column), 0.0);
        }

        private static int[] Longest(List<int[]> rims)
        {
            int[] longest = rims[0];
            foreach (int[] rim in rims)
                longest = rim.Length > longest.Length ? rim : longest;
            return longest;
        }
    }
}
