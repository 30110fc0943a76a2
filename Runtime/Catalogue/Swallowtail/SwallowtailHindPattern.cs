using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail's hind wing, drawn for this package: yellow between veins around a closed discal cell, a black border with yellow
    /// crescents and clouds of blue scales, a black tail, and a red eye near the body. Places are wing lengths.
    /// </summary>
    internal sealed class SwallowtailHindPattern : WingPattern
    {
        private const double k_BorderWidth = 0.23, k_RimWidth = 0.016, k_FoldWidth = 0.05, k_TailRoot = -0.985, k_FoldEnd = 0.3,
            k_BaseReach = 0.16, k_Beyond = 0.3;
        private const double k_EyeSpan = 0.372, k_EyeForward = -0.868, k_EyeRadius = 0.058;

        // Sc + R1; Rs along the cell and on; Cu along the cell; M1, M2, M3; CuA1, into the tail; CuA2; 2A, 3A; the end of the cell.
        private static readonly double[][] s_Veins =
        {
            new[] { 0.01, 0.005, 0.2, 0.018, 0.45, -0.028, 0.7, -0.1, 0.9, -0.168 },
            new[] { 0.01, 0.0, 0.2, -0.032, 0.42, -0.1, 0.68, -0.205, 0.975, -0.352 },
            new[] { 0.01, -0.01, 0.12, -0.1, 0.2, -0.185, 0.28, -0.262, 0.36, -0.307, 0.402, -0.312, 0.455, -0.27 },
            new[] { 0.46, -0.14, 0.62, -0.235, 0.78, -0.365, 0.935, -0.545 },
            new[] { 0.475, -0.2, 0.62, -0.325, 0.76, -0.49, 0.865, -0.69 },
            new[] { 0.455, -0.27, 0.57, -0.42, 0.68, -0.61, 0.775, -0.845 },
            new[] { 0.402, -0.312, 0.49, -0.5, 0.56, -0.72, 0.6, -0.96, 0.613, -1.34 },
            new[] { 0.28, -0.262, 0.36, -0.48, 0.42, -0.72, 0.456, -0.968 },
            new[] { 0.008, -0.02, 0.1, -0.2, 0.18, -0.42, 0.25, -0.65, 0.3, -0.91 },
            new[] { 0.005, -0.03, 0.055, -0.2, 0.1, -0.4, 0.15, -0.6 },
            new[] { 0.42, -0.1, 0.444, -0.117, 0.46, -0.14, 0.475, -0.2, 0.468, -0.24, 0.455, -0.27 },
        };

        private static readonly double[] s_Tips =
        {
            0.975, -0.352, 0.935, -0.545, 0.865, -0.69, 0.775, -0.845, 0.6, -0.985, 0.456, -0.968,
        };

        // The outer margin, past the tail.
        private static readonly double[] s_Margin =
        {
            1.0, -0.33, 0.976, -0.44, 0.924, -0.57, 0.853, -0.712, 0.779, -0.841, 0.7, -0.945, 0.6, -0.985, 0.456,
            -0.97, 0.368, -0.955, 0.279, -0.897,
        };

        private readonly StrokeSet m_Veins = new StrokeSet();
        private readonly StrokeSet m_Border = new StrokeSet();
        private readonly StrokeSet m_Rim = new StrokeSet();
        private readonly StrokeSet m_Body = new StrokeSet();
        private readonly MarginSpots m_Spots;

        /// <param name="outline">The outline to draw into.</param>
        public SwallowtailHindPattern(WingOutline outline)
        {
            List<double> margin = Ink.Smooth(s_Margin);
            m_Border.Add(Ink.Extended(margin, k_Beyond));
            m_Spots = new MarginSpots(margin, s_Tips, default);
            List<double> rim = Ink.Edge(outline.LeadingAt, 0, 1);
            rim.AddRange(Ink.Edge(outline.TrailingAt, 1, 0));
            m_Rim.Add(rim);
            m_Body.Add(Ink.Edge(outline.TrailingAt, 0, k_FoldEnd));
            foreach (double[] vein in s_Veins)
                m_Veins.Add(Ink.Smooth(vein));
        }

        /// <inheritdoc/>
        public override Color Underside => SwallowtailColours.Underside;

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double vein = m_Veins.Distance(span, forward, out _, SwallowtailColours.VeinReach(softness));
            double reach = SwallowtailColours.BorderReach(k_BorderWidth, softness);
            double edge = m_Border.Distance(span, forward, out _, reach);
            Color colour = SwallowtailColours.Ground(0.7 + forward, vein, span, forward, softness);
            double fromBase = Math.Sqrt(span * span + forward * forward);
            float dusk = Math.Max(Ink.Within(fromBase, k_BaseReach, 0.12), 0.75f * m_Body.Line(span, forward, k_FoldWidth, 0.05));
            colour = SwallowtailColours.Dusted(colour, SwallowtailColours.Black, dusk, span, forward, softness);
            float dark = Math.Max(
                SwallowtailColours.Vein(vein, softness),
                Ink.Within(edge, SwallowtailColours.Scalloped(k_BorderWidth, vein), softness + 0.008));
            dark = Math.Max(dark, Ink.Within(forward, k_TailRoot, softness));
            colour = Color.Lerp(colour, SwallowtailColours.Black, dark);
            float onWing = Ink.Within(-forward, -k_TailRoot, softness);
            if (edge <= reach)
            {
                float blue = m_Spots.At(span, forward, 0.155, 0.056, 0.042, 0.03) * onWing;
                colour = SwallowtailColours.Dusted(colour, SwallowtailColours.Blue, 0.85f * blue, span, forward, softness);
                colour = Color.Lerp(colour, SwallowtailColours.Yellow, onWing * m_Spots.At(span, forward, 0.06, 0.05, 0.027, softness));
            }

            colour = Eye(colour, span - k_EyeSpan, forward - k_EyeForward, softness);
            return Color.Lerp(colour, SwallowtailColours.Black, m_Rim.Line(span, forward, k_RimWidth, softness));
        }

        // A black ring, blue above, red below.
        private static Color Eye(Color colour, double x, double z, double softness)
        {
            colour = Color.Lerp(colour, SwallowtailColours.Black, Ink.Ellipse(x, z, 1.45 * k_EyeRadius, 1.6 * k_EyeRadius, softness));
            var blue = Color.Lerp(colour, SwallowtailColours.Blue, Ink.Ellipse(x, z - 0.03, 1.15 * k_EyeRadius, k_EyeRadius, softness));
            blue = Color.Lerp(blue, SwallowtailColours.Black, Ink.Ellipse(x, z, 1.15 * k_EyeRadius, k_EyeRadius, softness));
            return Color.Lerp(blue, SwallowtailColours.Red, Ink.Ellipse(x, z, k_EyeRadius, 0.85 * k_EyeRadius, softness));
        }
    }
}
