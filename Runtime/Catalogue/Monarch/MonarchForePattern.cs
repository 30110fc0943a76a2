using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// The fore wing of a monarch: orange between the veins of Comstock and Needham's system around a closed discal cell, a dark costa, and
    /// a dark tip with pale windows and two rows of spots.
    /// </summary>
    internal sealed class MonarchForePattern : WingPattern
    {
        private const double k_MarginStart = 0.9, k_MarginWidth = 0.05, k_CostaWidth = 0.012, k_BaseReach = 0.07, k_FirstSpot = 0.02,
            k_Creep = 0.035, k_CreepReach = 0.02;

        private static readonly Color s_Ground = new Color(0.87f, 0.40f, 0.07f);
        private static readonly Color s_Bright = new Color(0.93f, 0.50f, 0.12f);
        private static readonly Color s_Window = new Color(0.94f, 0.64f, 0.31f);

        // Sc; R to the end of the cell and on to R5; R1, R2, R3, R4; Cu along the cell; M1, M2, M3; CuA1, CuA2; 2A; the end of the cell.
        private static readonly double[][] s_Veins =
        {
            new[] { 0.01, 0.004, 0.15, 0.055, 0.33, 0.106, 0.47, 0.142, 0.575, 0.166 },
            new[] { 0.01, 0.002, 0.14, 0.038, 0.3, 0.077, 0.45, 0.107, 0.56, 0.121, 0.76, 0.134, 0.985, 0.128 },
            new[] { 0.39, 0.096, 0.5, 0.126, 0.6, 0.154, 0.68, 0.172 },
            new[] { 0.49, 0.113, 0.62, 0.143, 0.72, 0.163, 0.79, 0.174 },
            new[] { 0.57, 0.122, 0.7, 0.144, 0.8, 0.16, 0.885, 0.174 },
            new[] { 0.7, 0.1315, 0.82, 0.146, 0.93, 0.161 },
            new[] { 0.01, -0.002, 0.15, 0.001, 0.3, 0.006, 0.4, 0.02, 0.452, 0.042 },
            new[] { 0.47, 0.099, 0.64, 0.1, 0.82, 0.097, 0.985, 0.089 },
            new[] { 0.476, 0.074, 0.63, 0.063, 0.8, 0.05, 0.962, 0.042 },
            new[] { 0.452, 0.042, 0.6, 0.021, 0.76, 0.006, 0.913, -0.002 },
            new[] { 0.37, 0.0125, 0.52, -0.012, 0.68, -0.033, 0.85, -0.05 },
            new[] { 0.235, 0.002, 0.4, -0.03, 0.58, -0.062, 0.785, -0.092 },
            new[] { 0.01, -0.007, 0.18, -0.036, 0.42, -0.076, 0.6, -0.106, 0.74, -0.132 },
            new[] { 0.45, 0.107, 0.468, 0.1, 0.477, 0.088, 0.476, 0.074, 0.469, 0.056, 0.452, 0.042 },
        };

        // Span beyond which the tip is dark, over the place ahead.
        private static readonly double[] s_TipForward = { -0.02, 0.0, 0.02, 0.05, 0.085, 0.13, 0.16, 0.2 };
        private static readonly double[] s_TipSpan = { 0.97, 0.905, 0.84, 0.755, 0.67, 0.6, 0.565, 0.53 };

        // Middle, half length, half width.
        private static readonly double[] s_Windows =
        {
            0.705, 0.116, 0.038, 0.0095, 0.745, 0.081, 0.04, 0.0125, 0.805, 0.071, 0.026, 0.0075,
        };

        private static readonly double[] s_Pale =
        {
            0.655, 0.152, 0.016, 0.005, 0.725, 0.153, 0.018, 0.0055, 0.79, 0.151, 0.018, 0.0055, 0.828, 0.118, 0.02, 0.007, 0.85, 0.088,
            0.02, 0.008, 0.878, 0.062, 0.015, 0.0075,
        };

        private readonly StrokeSet m_Veins = new StrokeSet();
        private readonly StrokeSet m_Costa = new StrokeSet();
        private readonly StrokeSet m_Margin = new StrokeSet();
        private readonly MonotoneCurve m_Tip = MonotoneCurve.Straight(s_TipForward, s_TipSpan).Smoothed();

        /// <summary>Lays the pattern into an outline.</summary>
        public MonarchForePattern(WingOutline outline)
        {
            foreach (double[] vein in s_Veins)
                m_Veins.Add(Ink.Smooth(vein));
            m_Costa.Add(Ink.Edge(outline.LeadingAt, 0, k_MarginStart));
            List<double> margin = Ink.Edge(outline.LeadingAt, k_MarginStart, 1);
            margin.AddRange(Ink.Edge(outline.TrailingAt, 1, MonarchPattern.Notch));
            Spots = MonarchColours.Spots(margin, k_FirstSpot, double.MaxValue);
            m_Margin.Add(margin);
        }

        /// <summary>Middles and radii of the spots of the margin, span, forward, radius, …</summary>
        internal double[] Spots { get; }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double vein = m_Veins.Distance(span, forward, out _, MonarchColours.VeinReach(softness));
            double edge = m_Margin.Distance(span, forward, out _, MonarchColours.MarginReach(softness));
            var ground = Color.Lerp(s_Bright, s_Ground, Ink.Within(span, 0.4, 0.5));
            Color colour = MonarchColours.Ground(ground, vein, span, forward, softness);
            double fromBase = Math.Sqrt(span * span + forward * forward);
            float dark = 0.8f * Ink.Within(fromBase, k_BaseReach, k_BaseReach);
            // The dark of the tip creeps along the veins.
            double tip = m_Tip.At(Math.Clamp(forward, -0.02, 0.2)) - k_Creep * Ink.Fade(vein, k_CreepReach);
            dark = Math.Max(dark, Ink.Within(tip - span, 0, 0.01 + softness));
            colour = Color.Lerp(colour, MonarchColours.Dark, dark);
            colour = Color.Lerp(colour, s_Window, Ink.Ellipses(s_Windows, span, forward, softness));
            dark = MonarchColours.Vein(vein, edge, softness);
            dark = Math.Max(dark, Ink.Within(edge, k_MarginWidth, softness));
            dark = Math.Max(dark, m_Costa.Line(span, forward, k_CostaWidth, softness));
            colour = Color.Lerp(colour, MonarchColours.Dark, dark);
            float spots = Math.Max(
                MonarchColours.Spotted(Spots, span, forward, softness), Ink.Ellipses(s_Pale, span, forward, softness));
            return Color.Lerp(colour, MonarchColours.Spot, spots);
        }
    }
}
