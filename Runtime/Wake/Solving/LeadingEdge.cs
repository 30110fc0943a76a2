using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Suction of a sharp leading edge from the circulation of the first ring behind it: S = π ρ C²/4 a length of edge, where the
    /// vorticity of the sheet is C/√x near the edge, and Γ₁ = κ C √Δx.
    /// </summary>
    internal static class LeadingEdge
    {
        /// <summary>κ of a flat plate in two dimensions: π/2 for one panel, √π for many.</summary>
        /// <param name="panels">Panels along the chord.</param>
        public static double Factor(int panels)
        {
            var system = new LinearSystem(panels);
            for (int row = 0; row < panels; row++)
            {
                // Vortices at a quarter of the panels, unit wash at three quarters, panels of unit length.
                for (int column = 0; column < panels; column++)
                    system.Set(row, column, 1.0 / (2.0 * Math.PI * (row - column + 0.5)));
                system.SetRight(row, 1.0);
            }

            float[] strengths = new float[panels];
            system.Solve(strengths);
            return strengths[0] / (2.0 * Math.Sqrt(panels));
        }

        /// <summary>Suction of a strip over the density, and the cosine of the edge's sweep.</summary>
        /// <param name="lattice">The wing.</param>
        /// <param name="j">The strip.</param>
        /// <param name="factor">κ.</param>
        /// <param name="cosine">Cosine of the angle between the edge and what is across the chord.</param>
        public static float Suction(WingLattice lattice, int j, double factor, out float cosine)
        {
            float3 chord = lattice.Chordwise(0, j);
            float3 edge = lattice.Corners[lattice.Corner(0, j + 1)] - lattice.Corners[lattice.Corner(0, j)];
            float length = math.length(chord), span = math.length(edge);
            cosine = math.length(math.cross(chord, edge)) / math.max(length * span, 1e-20f);
            float circulation = lattice.Circulation[lattice.Ring(0, j)];
            return (float)(math.PI * circulation * circulation * span * cosine / (4.0 * factor * factor * math.max(length, 1e-12f)));
        }
    }
}
