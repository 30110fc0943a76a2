using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A painted lichen moth's colours, drawn for this package: grey stripes along a fore wing that turns from yellow to orange red, and a
    /// pink hind wing with a grey border. Laid by eye into the outline of the couple.
    /// </summary>
    internal sealed class LichenMothPattern : WingPattern
    {
        private const double k_Tornus = 0.77, k_TipStart = 0.83, k_SeamStart = -0.03, k_SeamSlope = -0.27, k_BorderWidth = 0.085,
            k_SeamHalfWidth = 0.006;
        private const double k_VeinHalfWidth = 0.004, k_LeastFeature = 0.3;

        private static readonly Color s_Yellow = new Color(0.95f, 0.76f, 0.30f);
        private static readonly Color s_Red = new Color(0.90f, 0.36f, 0.18f);
        private static readonly Color s_Grey = new Color(0.32f, 0.31f, 0.34f);
        private static readonly Color s_Pink = new Color(0.94f, 0.60f, 0.55f);
        private static readonly Color s_PinkBase = new Color(0.96f, 0.72f, 0.62f);

        private readonly WingOutline m_Outline;
        private readonly VeinFan m_Veins;
        private readonly StrokeSet m_HindMargin = new StrokeSet();

        /// <param name="outline">The outline of the couple.</param>
        public LichenMothPattern(WingOutline outline)
        {
            m_Outline = outline;
            m_HindMargin.Add(Ink.Edge(outline.TrailingAt, 0.3, k_Tornus));
            m_Veins = new VeinFan(outline, 0.25).Add(0.56, 0.6, 0.64, 0.68, 0.73, 0.79, 0.86);
        }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double inner = Math.Clamp(span, 0, k_Tornus);
            double seam = k_SeamStart + k_SeamSlope * span;
            double width = m_Outline.LeadingAt(inner) - k_SeamStart - k_SeamSlope * inner;
            double across = (m_Outline.LeadingAt(Math.Clamp(span, 0, k_TipStart)) - forward) / width;
            double blend = softness / Math.Max(width, 0.05);
            float hind = span < k_Tornus ? Ink.Within(-across, -1, blend) : 0f;
            Color colour = ForeWing(span, across, blend);
            if (hind > 0f)
                colour = Color.Lerp(colour, HindWing(span, forward, softness), hind);
            float seamLine = span < k_Tornus ? Ink.Within(Math.Abs(forward - seam), k_SeamHalfWidth, softness) : 0f;
            return Color.Lerp(colour, s_Grey, seamLine);
        }

        private Color ForeWing(double span, double across, double blend)
        {
            var colour = Color.Lerp(s_Yellow, s_Red, Ink.Within(-span, -0.52, 0.55));
            float costa = Ink.Within(across, 0.15 + 0.03 * span, blend);
            float middle = Ink.Between(across, 0.40, 0.47 + 0.16 * span, blend) * Ink.Within(-span, -0.24, 0.1);
            float inner = Ink.Within(-across, -(0.88 - 0.16 * span), blend) * Ink.Within(span, 0.95, 0.1);
            return Color.Lerp(colour, s_Grey, Math.Max(costa, Math.Max(middle, inner)));
        }

        private Color HindWing(double span, double forward, double softness)
        {
            var colour = Color.Lerp(s_Pink, s_PinkBase, Ink.Within(Math.Sqrt(span * span + forward * forward), 0.25, 0.3));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            colour = Color.Lerp(colour, s_Grey, 0.35f * m_Veins.Veins(span, forward, vein, softness));
            double edge = m_HindMargin.Distance(span, forward, out double along, k_BorderWidth + softness + 0.02);
            double width = k_BorderWidth * Math.Clamp(0.35 + 1.3 * along, 0.35, 1);
            return Color.Lerp(colour, s_Grey, Ink.Within(edge, width, softness + 0.02));
        }
    }
}
