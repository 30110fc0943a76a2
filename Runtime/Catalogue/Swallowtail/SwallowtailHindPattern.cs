using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail's hind wing, drawn for this package: yellow between black veins, a black border dusted with blue, yellow crescents at
    /// the margin, a black tail, and a red eye near the body.
    /// </summary>
    internal sealed class SwallowtailHindPattern : WingPattern
    {
        private const double k_VeinHalfWidth = 0.006, k_LeastFeature = 0.35, k_RimWidth = 0.018;
        private const double k_BorderWidth = 0.17, k_Beyond = 0.3, k_CrescentSpacing = 0.125;
        private const double k_BeltWidth = 0.085, k_Scallop = 0.014, k_SpotSpacing = 0.128, k_BeltLength = 0.77;
        private const double k_EyeSpan = 0.345, k_EyeForward = -0.84, k_EyeRadius = 0.066, k_TailRoot = -0.99;

        /// <summary>Places of the blue spots.</summary>
        private static readonly double[] s_Belt =
        {
            0.815, -0.31, 0.805, -0.40, 0.775, -0.49, 0.73, -0.575, 0.675, -0.65, 0.61,
            -0.715, 0.54, -0.76, 0.47, -0.785, 0.40, -0.79, 0.33, -0.78, 0.22, -0.75,
        };

        private readonly VeinFan m_Veins;
        private readonly StrokeSet m_Belt = new StrokeSet();
        private readonly StrokeSet m_Foot = new StrokeSet();
        private readonly StrokeSet m_Border = new StrokeSet();
        private readonly StrokeSet m_Rim = new StrokeSet();
        private readonly StrokeSet m_InnerMargin = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        public SwallowtailHindPattern(WingOutline outline)
        {
            m_Border.Add(Ink.Extended(Ink.Margin(outline, 0.285, 0.475), k_Beyond), -k_Beyond);
            m_Foot.Add(new[] { 0.72, -0.97, 0.2, -0.97 });
            m_Belt.Add(s_Belt);
            m_Rim.Add(Ink.Margin(outline, 0, 1));
            m_InnerMargin.Add(Ink.Margin(outline, 0.82, 1));
            m_Veins = new VeinFan(outline, 0.3).Add(0.24, 0.30, 0.348, 0.396, 0.442, 0.594, 0.745, 0.80)
                .Cross(1, 0.52).Cross(2, 0.5).Cross(3, 0.48).Cross(4, 0.44);
        }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            var colour = Color.Lerp(SwallowtailColours.Yellow, SwallowtailColours.Pale, Ink.Within(-forward, 0.25, 0.3));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            float dark = m_Veins.Veins(span, forward, vein, softness);
            dark = Math.Max(dark, m_Veins.CrossVeins(span, forward, vein, softness));
            colour = Color.Lerp(colour, SwallowtailColours.Dusk, m_InnerMargin.Line(span, forward, 0.055, 0.05));
            double belt = m_Belt.Distance(span, forward, out double onBelt, k_BeltWidth + k_Scallop + softness);
            double edge = m_Border.Distance(span, forward, out double onEdge, k_BorderWidth + softness);
            double foot = m_Foot.Distance(span, forward, out double onFoot, k_BorderWidth + softness);
            double inner = k_BeltWidth + k_Scallop * Math.Cos(2 * Math.PI * onBelt / k_SpotSpacing);
            dark = Math.Max(dark, Math.Max(Ink.Within(belt, inner, softness), Ink.Within(Math.Min(edge, foot), k_BorderWidth, softness)));
            colour = Color.Lerp(colour, SwallowtailColours.Black, dark);
            float blue =
                Ink.Row(onBelt, belt, k_SpotSpacing, 0, 0.047, 0.036, softness + 0.02) * Ink.Between(onBelt, 0, k_BeltLength, softness);
            colour = Color.Lerp(colour, SwallowtailColours.Blue, 0.85f * blue);
            float outer = Ink.Row(onEdge, edge, k_CrescentSpacing, 0.066, 0.042, 0.025, softness) * Ink.Between(
                onEdge, k_CrescentSpacing, 6 * k_CrescentSpacing, softness);
            float lower = Ink.Row(onFoot, foot, k_CrescentSpacing, 0.062, 0.045, 0.022, softness) * Ink.Between(
                onFoot, k_CrescentSpacing, 2 * k_CrescentSpacing, softness);
            colour = Color.Lerp(colour, SwallowtailColours.Yellow, Math.Max(outer, lower));
            colour = Eye(colour, span, forward, softness);
            float rim = Math.Max(m_Rim.Line(span, forward, k_RimWidth, softness), Ink.Within(forward, k_TailRoot, softness));
            return Color.Lerp(colour, SwallowtailColours.Black, rim);
        }

        private static Color Eye(Color colour, double span, double forward, double softness)
        {
            double x = span - k_EyeSpan;
            double z = forward - k_EyeForward;
            colour = Color.Lerp(colour, SwallowtailColours.Black, Ink.Ellipse(x, z, 1.5 * k_EyeRadius, 1.5 * k_EyeRadius, softness));
            colour = Color.Lerp(colour, SwallowtailColours.Blue, Ink.Ellipse(x, z - 0.035, 1.1 * k_EyeRadius, k_EyeRadius, softness));
            return Color.Lerp(colour, SwallowtailColours.Red, Ink.Ellipse(x, z, k_EyeRadius, 0.85 * k_EyeRadius, softness));
        }
    }
}
