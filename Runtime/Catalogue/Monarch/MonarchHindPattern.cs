using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// The hind wing of a monarch: orange between veins around a closed discal cell, a dark margin with two rows of spots, a pale fold
    /// along the body, and the scent patch of a male on vein CuA2.
    /// </summary>
    internal sealed class MonarchHindPattern : WingPattern
    {
        /// <summary>Span of the tornus, where the outer margin meets that along the body.</summary>
        private const double k_Tornus = 0.33;
        private const double k_MarginWidth = 0.056, k_FoldWidth = 0.045, k_RimWidth = 0.006, k_BaseReach = 0.06, k_FirstSpot = 0.025,
            k_Taper = 0.1;

        private static readonly Color s_Ground = new Color(0.87f, 0.41f, 0.08f);
        private static readonly Color s_Bright = new Color(0.93f, 0.52f, 0.15f);
        private static readonly Color s_Fold = new Color(0.80f, 0.56f, 0.33f);

        // Sc + R1; Rs along the cell and on; Cu along the cell; M1, M2, M3; CuA1, CuA2; 2A, 3A; the end of the cell.
        private static readonly double[][] s_Veins =
        {
            new[] { 0.01, -0.014, 0.2, -0.082, 0.45, -0.146, 0.6, -0.186, 0.698, -0.212 },
            new[] { 0.01, -0.017, 0.17, -0.088, 0.33, -0.139, 0.5, -0.19, 0.662, -0.258 },
            new[] { 0.01, -0.022, 0.11, -0.1, 0.2, -0.172, 0.26, -0.207, 0.315, -0.222 },
            new[] { 0.366, -0.163, 0.45, -0.204, 0.54, -0.256, 0.617, -0.311 },
            new[] { 0.35, -0.19, 0.42, -0.246, 0.5, -0.313, 0.562, -0.371 },
            new[] { 0.315, -0.222, 0.385, -0.293, 0.45, -0.363, 0.505, -0.424 },
            new[] { 0.26, -0.207, 0.335, -0.297, 0.4, -0.38, 0.446, -0.453 },
            new[] { 0.2, -0.172, 0.275, -0.27, 0.33, -0.345, 0.381, -0.417 },
            new[] { 0.01, -0.026, 0.1, -0.115, 0.2, -0.222, 0.315, -0.343 },
            new[] { 0.01, -0.028, 0.07, -0.085, 0.13, -0.143, 0.185, -0.196 },
            new[] { 0.33, -0.139, 0.352, -0.147, 0.366, -0.163, 0.361, -0.178, 0.35, -0.19, 0.336, -0.208, 0.315, -0.222 },
        };

        // Middle, half length, half width.
        private static readonly double[] s_ScentPatch = { 0.266, -0.257, 0.0095, 0.0095 };

        private readonly StrokeSet m_Veins = new StrokeSet();
        private readonly StrokeSet m_Margin = new StrokeSet();
        private readonly StrokeSet m_Body = new StrokeSet();
        private readonly double m_MarginLength;

        /// <summary>Lays the pattern into an outline.</summary>
        public MonarchHindPattern(WingOutline outline)
        {
            foreach (double[] vein in s_Veins)
                m_Veins.Add(Ink.Smooth(vein));
            List<double> margin = Ink.Edge(outline.TrailingAt, MonarchPattern.Notch, k_Tornus);
            m_MarginLength = Ink.Length(margin);
            Spots = MonarchColours.Spots(margin, k_FirstSpot, m_MarginLength - k_Taper);
            m_Margin.Add(margin);
            m_Body.Add(Ink.Edge(outline.TrailingAt, k_Tornus, 0));
        }

        /// <summary>Middles and radii of the spots of the margin, span, forward, radius, …</summary>
        internal double[] Spots { get; }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double vein = m_Veins.Distance(span, forward, out _, MonarchColours.VeinReach(softness));
            double edge = m_Margin.Distance(span, forward, out double along, MonarchColours.MarginReach(softness));
            double body = m_Body.Distance(span, forward, out _, k_FoldWidth + softness);
            double fromBase = Math.Sqrt(span * span + forward * forward);
            var ground = Color.Lerp(s_Bright, s_Ground, Ink.Within(fromBase, 0.3, 0.3));
            ground = Color.Lerp(ground, s_Fold, Ink.Within(body, 0.5 * k_FoldWidth, k_FoldWidth));
            Color colour = MonarchColours.Ground(ground, vein, span, forward, softness);
            float dark = 0.8f * Ink.Within(fromBase, k_BaseReach, k_BaseReach);
            dark = Math.Max(dark, MonarchColours.Vein(vein, edge, softness));
            double width = k_MarginWidth * Math.Clamp((m_MarginLength - along) / k_Taper, 0, 1);
            dark = Math.Max(dark, Ink.Within(edge, Math.Max(width, k_RimWidth), softness));
            dark = Math.Max(dark, Ink.Within(body, k_RimWidth, softness));
            dark = Math.Max(dark, Ink.Ellipses(s_ScentPatch, span, forward, softness));
            colour = Color.Lerp(colour, MonarchColours.Dark, dark);
            return Color.Lerp(colour, MonarchColours.Spot, MonarchColours.Spotted(Spots, span, forward, softness));
        }
    }
}
