using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A painted lichen moth's colours, drawn for this package: two grey stripes along a yellow fore wing, orange red between their outer
    /// ends, which lies on a pink hind wing with a grey border. Laid by eye into the outline of the couple, in wing lengths.
    /// </summary>
    internal sealed class LichenMothPattern : WingPattern
    {
        private const double k_Tornus = 0.77, k_SeamStart = -0.03, k_SeamSlope = -0.27, k_BorderStart = 0.2, k_BorderWidth = 0.085,
            k_BorderTaper = 0.3;

        // Of the fringe of grey hairs along the outer margins.
        private const double k_RimWidth = 0.012, k_Ragged = 0.5, k_Hairs = 420, k_MoreHairs = 1130, k_FringeStart = 0.93,
            k_TipForward = 0.1;

        private const double k_VeinHalfWidth = 0.0035, k_LeastFeature = 0.3, k_GrainSize = 0.006, k_ShadowWidth = 0.04, k_Blur = 0.007;
        private const float k_Grain = 0.07f, k_Shadow = 0.35f, k_ForeVein = 0.22f, k_HindVein = 0.4f, k_Streak = 0.6f;

        private static readonly Color s_Yellow = new Color(0.95f, 0.76f, 0.30f);
        private static readonly Color s_Red = new Color(0.90f, 0.36f, 0.18f);
        private static readonly Color s_Grey = new Color(0.31f, 0.30f, 0.33f);
        private static readonly Color s_Pink = new Color(0.94f, 0.60f, 0.55f);
        private static readonly Color s_PinkBase = new Color(0.96f, 0.72f, 0.62f);

        private static readonly double[] s_Spans = { 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.83, 1 };

        // Edges of the grey stripes: of the one behind the leading edge, then of the wedge before the hind wing.
        private static readonly MonotoneCurve
            s_StripeUpper = Edge(0.004, 0.045, 0.082, 0.108, 0.126, 0.138, 0.147, 0.152, 0.155, 0.15),
            s_StripeLower = Edge(0, 0.034, 0.062, 0.077, 0.083, 0.081, 0.076, 0.068, 0.058, 0.055),
            s_WedgeUpper = Edge(-0.06, -0.06, -0.06, -0.058, -0.054, -0.047, -0.04, -0.034, -0.028, -0.025),
            s_WedgeLower = Edge(-0.06, -0.06, -0.06, -0.062, -0.07, -0.086, -0.105, -0.118, -0.11, -0.1);

        private readonly VeinFan m_ForeVeins;
        private readonly VeinFan m_HindVeins;
        private readonly StrokeSet m_HindMargin = new StrokeSet();
        private readonly StrokeSet m_Rim = new StrokeSet();

        /// <param name="outline">The outline of the couple.</param>
        public LichenMothPattern(WingOutline outline)
        {
            m_HindMargin.Add(Ink.Edge(outline.TrailingAt, k_BorderStart, k_Tornus));
            m_Rim.Add(Ink.Edge(outline.TrailingAt, 0, 1));
            m_Rim.Add(Ink.Edge(outline.LeadingAt, k_FringeStart - 0.05, 1));
            m_HindVeins = new VeinFan(outline, 0.25).Add(0.56, 0.6, 0.64, 0.68, 0.73, 0.79, 0.86);
            m_ForeVeins = new VeinFan(outline, 0.4).Add(0.3, 0.335, 0.37, 0.4, 0.43, 0.46, 0.49, 0.52);
        }

        /// <inheritdoc/>
        public override Color Underside => new Color(0.93f, 0.74f, 0.66f, 0.45f);

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double below = k_SeamStart + k_SeamSlope * span - forward;
            float hind = span < k_Tornus ? Ink.Within(-below, 0, softness) : 0f;
            Color colour = hind < 1f ? ForeWing(span, forward, softness) : default;
            if (hind > 0f)
            {
                double shade = 1 - k_Shadow * Ink.Fade(below, k_ShadowWidth);
                colour = Color.Lerp(colour, Ink.Lit(HindWing(span, forward, softness), shade), hind);
            }

            double fringe = m_Rim.Distance(span, forward, out double along, 2 * k_RimWidth + softness);
            double hairs = k_RimWidth * (1 + k_Ragged * Math.Sin(k_Hairs * along) * Math.Sin(k_MoreHairs * along));
            if (forward > k_TipForward)
                hairs *= Ink.Within(-span, -k_FringeStart, 0.05);
            colour = Color.Lerp(colour, s_Grey, Ink.Within(fringe, hairs, 0.5 * k_RimWidth + softness));
            return Ink.Lit(colour, 1 + k_Grain * Ink.Grain(span, forward, k_GrainSize, softness));
        }

        private Color ForeWing(double span, double forward, double softness)
        {
            double place = Math.Clamp(span, 0, 1), blur = k_Blur + softness, upper = s_StripeUpper.At(place),
                seam = k_SeamStart + k_SeamSlope * span;
            // Red lies between the stripes alone: the leading edge and what borders on the hind wing stay yellow.
            float red = Ink.Within(-span, -0.5, 0.4) * Ink.Between(forward, seam + 0.06, upper + 0.03, 0.06);
            var colour = Color.Lerp(s_Yellow, s_Red, red);
            float stripe = Ink.Between(forward, s_StripeLower.At(place), upper, blur) * Ink.Within(-span, -0.06, 0.08);
            float wedge = Ink.Between(forward, s_WedgeLower.At(place), s_WedgeUpper.At(place), blur) * Ink.Within(-span, -0.36, 0.1);
            float streak = k_Streak * Ink.Between(forward, seam + 0.012, seam + 0.04, blur) * Ink.Between(span, 0.08, 0.3, 0.08);
            colour = Color.Lerp(colour, s_Grey, Math.Max(streak, Math.Max(stripe, wedge)));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            return Color.Lerp(colour, s_Grey, k_ForeVein * m_ForeVeins.Veins(span, forward, vein, softness + k_VeinHalfWidth));
        }

        private Color HindWing(double span, double forward, double softness)
        {
            var colour = Color.Lerp(s_Pink, s_PinkBase, Ink.Within(Math.Sqrt(span * span + forward * forward), 0.25, 0.3));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            colour = Color.Lerp(colour, s_Grey, k_HindVein * m_HindVeins.Veins(span, forward, vein, softness + k_VeinHalfWidth));
            double edge = m_HindMargin.Distance(span, forward, out double along, k_BorderWidth + 0.02 + softness);
            double width = k_BorderWidth * Math.Clamp(along / k_BorderTaper, 0, 1);
            return Color.Lerp(colour, s_Grey, Ink.Within(edge, width, softness + 0.02));
        }

        private static MonotoneCurve Edge(params double[] forward) => MonotoneCurve.Straight(s_Spans, forward).Smoothed();
    }
}
