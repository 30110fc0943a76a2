using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A monarch's colours, drawn for this package: orange ground, dark veins that fan out from a closed cell of each wing, a dark margin
    /// with a row of pale spots, and a dark fore wing tip with paler windows. Veins are laid by eye into the outline, in wing lengths.
    /// </summary>
    internal sealed class MonarchPattern : WingPattern
    {
        private const double k_VeinHalfWidth = 0.0045, k_ThinRimWidth = 0.014, k_MarginWidth = 0.055, k_SpotDepth = 0.027,
            k_SpotSpacing = 0.055, k_SpotRadius = 0.0115;
        private const double k_MarginStart = 0.93, k_MarginEnd = 0.4;
        private const double k_LeastFeature = 0.35;

        private static readonly Color s_Ground = new Color(0.90f, 0.44f, 0.08f);
        private static readonly Color s_Base = new Color(0.72f, 0.31f, 0.06f);
        private static readonly Color s_Dark = new Color(0.09f, 0.06f, 0.055f);
        private static readonly Color s_Spot = new Color(0.97f, 0.94f, 0.87f);
        private static readonly Color s_Window = new Color(0.96f, 0.66f, 0.34f);

        private static readonly double[][] s_Veins =
        {
            new[] { 0.01, 0.002, 0.12, 0.04, 0.25, 0.07, 0.5, 0.1, 0.75, 0.15 },
            new[] { 0.01, -0.002, 0.22, 0.014, 0.46, 0.022 },
            new[] { 0.5, 0.1, 0.49, 0.062, 0.46, 0.022 },
            new[] { 0.5, 0.1, 0.72, 0.125, 0.97, 0.12 },
            new[] { 0.497, 0.085, 0.75, 0.09, 0.985, 0.075 },
            new[] { 0.49, 0.062, 0.72, 0.055, 0.945, 0.03 },
            new[] { 0.475, 0.04, 0.68, 0.012, 0.875, -0.025 },
            new[] { 0.4, 0.02, 0.6, -0.03, 0.8, -0.075 },
            new[] { 0.25, 0.014, 0.5, -0.045, 0.735, -0.115 },
            new[] { 0.01, -0.008, 0.25, -0.045, 0.5, -0.085, 0.72, -0.15 },
            new[] { 0.01, -0.012, 0.2, -0.078, 0.36, -0.13 },
            new[] { 0.008, -0.018, 0.12, -0.125, 0.24, -0.22 },
            new[] { 0.36, -0.13, 0.315, -0.175, 0.24, -0.22 },
            new[] { 0.36, -0.13, 0.53, -0.165, 0.69, -0.21 },
            new[] { 0.35, -0.145, 0.5, -0.205, 0.64, -0.285 },
            new[] { 0.315, -0.175, 0.45, -0.26, 0.57, -0.36 },
            new[] { 0.275, -0.2, 0.39, -0.31, 0.49, -0.43 },
            new[] { 0.24, -0.22, 0.33, -0.34, 0.4, -0.45 },
            new[] { 0.17, -0.165, 0.25, -0.29, 0.3, -0.4 },
            new[] { 0.06, -0.06, 0.13, -0.18, 0.18, -0.28 },
        };

        private static readonly double[] s_Windows =
        {
            0.72, 0.122, 0.03, 0.012, 0.76, 0.08, 0.035, 0.013, 0.745, 0.04,
            0.035, 0.012, 0.86, 0.112, 0.018, 0.01, 0.88, 0.075, 0.018, 0.01,
            0.85, 0.035, 0.018, 0.01,
        };

        private readonly StrokeSet m_Veins = new StrokeSet();
        private readonly StrokeSet m_ThinRim = new StrokeSet();
        private readonly StrokeSet m_Margin = new StrokeSet();

        /// <summary>Lays the pattern into an outline.</summary>
        public MonarchPattern(WingOutline outline)
        {
            foreach (double[] vein in s_Veins)
                m_Veins.Add(vein);
            m_ThinRim.Add(Ink.Edge(outline.LeadingAt, 0, k_MarginStart));
            m_ThinRim.Add(Ink.Edge(outline.TrailingAt, k_MarginEnd, 0));
            List<double> margin = Ink.Edge(outline.LeadingAt, k_MarginStart, 1);
            margin.AddRange(Ink.Edge(outline.TrailingAt, 1, k_MarginEnd));
            m_Margin.Add(margin);
        }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            var colour = Color.Lerp(s_Ground, s_Base, Ink.Within(Math.Sqrt(span * span + forward * forward), 0.1, 0.16));
            colour = Color.Lerp(colour, s_Dark, Apex(span, forward, softness));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            colour = Color.Lerp(colour, s_Dark, m_Veins.Line(span, forward, vein, softness));
            colour = Color.Lerp(colour, s_Window, Windows(span, forward, 0.5 * softness));

            double edge = m_Margin.Distance(span, forward, out double along, k_MarginWidth + softness);
            colour = Color.Lerp(
                colour, s_Dark,
                Math.Max(Ink.Within(edge, k_MarginWidth, softness), m_ThinRim.Line(span, forward, k_ThinRimWidth, softness)));

            return Color.Lerp(colour, s_Spot, Ink.Row(along, edge, k_SpotSpacing, k_SpotDepth, k_SpotRadius, k_SpotRadius, 0.5 * softness));
        }

        private static float Apex(double span, double forward, double softness) =>
            Ink.Within(0.63 + 0.8 * (0.13 - forward) - span, 0, 2 * softness);

        private static float Windows(double span, double forward, double softness)
        {
            float inside = 0f;
            for (int i = 0; i < s_Windows.Length; i += 4)
            {
                double x = span - s_Windows[i];
                double z = forward - s_Windows[i + 1];
                inside = Math.Max(inside, Ink.Ellipse(x, z, s_Windows[i + 2], s_Windows[i + 3], softness));
            }

            return inside;
        }
    }
}
