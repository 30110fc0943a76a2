using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail's fore wing, drawn for this package: yellow between the veins of Comstock and Needham's system, a base dusted with
    /// black, bars across the discal cell, and a black border with a yellow spot in each cell. Places are wing lengths.
    /// </summary>
    internal sealed class SwallowtailForePattern : WingPattern
    {
        private const double k_BorderWidth = 0.15, k_CostaWidth = 0.013, k_RimWidth = 0.008, k_BarHalfWidth = 0.015, k_BaseReach = 0.19,
            k_Beyond = 0.3, k_Tornus = 0.745;

        // Sc; R to R5; R1, R2, R3, R4; Cu along the cell; M1, M2, M3; CuA1, CuA2; 2A; the end of the cell.
        private static readonly double[][] s_Veins =
        {
            new[] { 0.01, 0.012, 0.2, 0.112, 0.4, 0.206, 0.58, 0.29 },
            new[] { 0.01, 0.008, 0.2, 0.088, 0.35, 0.143, 0.47, 0.185, 0.62, 0.235, 0.8, 0.29, 0.99, 0.335 },
            new[] { 0.38, 0.154, 0.52, 0.226, 0.61, 0.284, 0.7, 0.337 },
            new[] { 0.44, 0.175, 0.58, 0.25, 0.68, 0.308, 0.79, 0.36 },
            new[] { 0.5, 0.195, 0.64, 0.262, 0.76, 0.322, 0.87, 0.373 },
            new[] { 0.64, 0.242, 0.76, 0.294, 0.86, 0.332, 0.955, 0.365 },
            new[] { 0.01, -0.002, 0.15, 0.015, 0.3, 0.03, 0.42, 0.052, 0.485, 0.092 },
            new[] { 0.488, 0.165, 0.65, 0.2, 0.8, 0.225, 0.965, 0.238 },
            new[] { 0.497, 0.13, 0.65, 0.145, 0.78, 0.152, 0.92, 0.16 },
            new[] { 0.485, 0.092, 0.62, 0.085, 0.75, 0.081, 0.88, 0.086 },
            new[] { 0.42, 0.052, 0.57, 0.026, 0.7, 0.011, 0.835, 0.008 },
            new[] { 0.3, 0.03, 0.45, -0.012, 0.62, -0.046, 0.79, -0.061 },
            new[] { 0.01, -0.01, 0.2, -0.05, 0.42, -0.088, 0.6, -0.112, 0.725, -0.146 },
            new[] { 0.47, 0.185, 0.488, 0.165, 0.497, 0.13, 0.485, 0.092 },
        };

        private static readonly double[][] s_Bars =
        {
            new[] { 0.312, 0.122, 0.326, 0.046 }, new[] { 0.415, 0.156, 0.425, 0.07 },
            new[] { 0.475, 0.175, 0.49, 0.16, 0.496, 0.13, 0.487, 0.1 },
        };

        private static readonly double[] s_Tips =
        {
            0.99, 0.335, 0.965, 0.238, 0.92, 0.16, 0.88, 0.086, 0.835, 0.008, 0.79, -0.061, 0.725, -0.146,
        };

        private readonly StrokeSet m_Veins = new StrokeSet();
        private readonly StrokeSet m_Border = new StrokeSet();
        private readonly StrokeSet m_Costa = new StrokeSet();
        private readonly StrokeSet m_Rear = new StrokeSet();
        private readonly StrokeSet m_Bars = new StrokeSet();
        private readonly MarginSpots m_Spots;

        /// <param name="outline">The outline to draw into.</param>
        public SwallowtailForePattern(WingOutline outline)
        {
            List<double> margin = Ink.Edge(outline.TrailingAt, 1, k_Tornus);
            m_Border.Add(Ink.Extended(margin, k_Beyond));
            m_Spots = new MarginSpots(margin, s_Tips, default);
            m_Costa.Add(Ink.Edge(outline.LeadingAt, 0, 1));
            m_Rear.Add(Ink.Edge(outline.TrailingAt, 0, k_Tornus));
            foreach (double[] vein in s_Veins)
                m_Veins.Add(Ink.Smooth(vein));
            foreach (double[] bar in s_Bars)
                m_Bars.Add(Ink.Smooth(bar));
        }

        /// <inheritdoc/>
        public override Color Underside => SwallowtailColours.Underside;

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double vein = m_Veins.Distance(span, forward, out _, SwallowtailColours.VeinReach(softness));
            double reach = SwallowtailColours.BorderReach(k_BorderWidth, softness);
            double edge = m_Border.Distance(span, forward, out _, reach);
            Color colour = SwallowtailColours.Ground(span, vein, span, forward, softness);
            double fromBase = Math.Sqrt(span * span + forward * forward);
            colour = SwallowtailColours.Dusted(colour, SwallowtailColours.Black, Ink.Within(fromBase, k_BaseReach, 0.16), span, forward,
                softness);
            double border = SwallowtailColours.Scalloped(k_BorderWidth, vein);
            float dark = Math.Max(SwallowtailColours.Vein(vein, softness), Ink.Within(edge, border, softness + 0.006));
            dark = Math.Max(dark, m_Costa.Line(span, forward, k_CostaWidth, softness));
            dark = Math.Max(dark, m_Rear.Line(span, forward, k_RimWidth, softness));
            dark = Math.Max(dark, m_Bars.Line(span, forward, k_BarHalfWidth, softness + 0.004));
            colour = Color.Lerp(colour, SwallowtailColours.Black, dark);
            if (edge > reach)
                return colour;
            float dust = Ink.Between(edge, 0.085, 0.125, 0.03) * (1f - SwallowtailColours.Vein(0.5 * vein, softness));
            colour = SwallowtailColours.Dusted(colour, SwallowtailColours.Yellow, 0.45f * dust, span, forward, softness);
            return Color.Lerp(colour, SwallowtailColours.Yellow, m_Spots.At(span, forward, 0.046, 0.026, 0.0165, softness));
        }
    }
}
