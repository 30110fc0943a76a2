using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A painted lichen moth's colours, drawn for this package: grey stripes along a fore wing that turns from yellow to orange red, which
    /// lies on a pink hind wing with a grey border. Laid by eye into the outline of the couple, in wing lengths.
    /// </summary>
    internal sealed class LichenMothPattern : WingPattern
    {
        private const double k_Tornus = 0.77, k_SeamStart = -0.03, k_SeamSlope = -0.27, k_BorderStart = 0.2, k_BorderWidth = 0.085,
            k_BorderTaper = 0.3, k_RimWidth = 0.012;

        private const double k_VeinHalfWidth = 0.0035, k_LeastFeature = 0.3, k_GrainSize = 0.006, k_ShadowWidth = 0.04, k_Blur = 0.007;
        private const float k_Grain = 0.07f, k_Shadow = 0.35f, k_ForeVein = 0.22f, k_HindVein = 0.4f;

        private static readonly Color s_Yellow = new Color(0.95f, 0.76f, 0.30f);
        private static readonly Color s_Red = new Color(0.90f, 0.36f, 0.18f);
        private static readonly Color s_Grey = new Color(0.31f, 0.30f, 0.33f);
        private static readonly Color s_Pink = new Color(0.94f, 0.60f, 0.55f);
        private static readonly Color s_PinkBase = new Color(0.96f, 0.72f, 0.62f);

        private static readonly double[] s_Spans = { 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.83, 1 };

        // Edges of the coloured bands between the stripes: of the front one, then of the rear one.
        private static readonly MonotoneCurve
            s_FrontUpper = Edge(0.012, 0.042, 0.086, 0.119, 0.144, 0.162, 0.174, 0.18, 0.182, 0.176),
            s_FrontLower = Edge(0.012, 0.024, 0.0375, 0.052, 0.062, 0.069, 0.072, 0.072, 0.068, 0.062),
            s_RearUpper = Edge(0.012, 0.017, 0.019, 0.019, 0.015, 0.006, -0.006, -0.021, -0.038, -0.05),
            s_RearLower = Edge(-0.022, -0.034, -0.047, -0.059, -0.07, -0.082, -0.092, -0.103, -0.112, -0.1);

        private readonly VeinFan m_ForeVeins;
        private readonly VeinFan m_HindVeins;
        private readonly StrokeSet m_HindMargin = new StrokeSet();
        private readonly StrokeSet m_Rim = new StrokeSet();

        /// <param name="outline">The outline of the couple.</param>
        public LichenMothPattern(WingOutline outline)
        {
            m_HindMargin.Add(Ink.Edge(outline.TrailingAt, k_BorderStart, k_Tornus));
            m_Rim.Add(Ink.Edge(outline.TrailingAt, 0, 1));
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

            colour = Color.Lerp(colour, s_Grey, m_Rim.Line(span, forward, k_RimWidth, k_RimWidth + softness));
            return Ink.Lit(colour, 1 + k_Grain * Ink.Grain(span, forward, k_GrainSize, softness));
        }

        private Color ForeWing(double span, double forward, double softness)
        {
            var colour = Color.Lerp(s_Yellow, s_Red, Ink.Within(-span, -0.52, 0.55));
            double place = Math.Clamp(span, 0, 1), blur = k_Blur + softness;
            float front = Ink.Between(forward, s_FrontLower.At(place), s_FrontUpper.At(place), blur);
            float rear = Ink.Between(forward, s_RearLower.At(place), s_RearUpper.At(place), blur);
            // The middle stripe begins at a quarter of the span.
            float middle = Ink.Between(forward, s_RearUpper.At(place), s_FrontLower.At(place), blur) * Ink.Within(span, 0.24, 0.1);
            colour = Color.Lerp(s_Grey, colour, Math.Max(middle, Math.Max(front, rear)));
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
