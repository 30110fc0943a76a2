using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A monarch's colours, drawn for this package: the fore wing lies on the hind wing, along a seam from the base to the notch of the
    /// margin between them. All places are laid by eye into the outline, in wing lengths.
    /// </summary>
    internal sealed class MonarchPattern : WingPattern
    {
        /// <summary>Span of the notch between the margins of both wings.</summary>
        public const double Notch = 0.706;

        private const double k_SeamHalfWidth = 0.0045, k_ShadowWidth = 0.035, k_ShadowDepth = 0.4;

        private static readonly double[] s_SeamSpans = { 0, 0.12, 0.3, 0.5, 0.62, Notch, 1 };
        private static readonly double[] s_SeamForward = { -0.017, -0.043, -0.084, -0.124, -0.15, -0.182, -0.24 };

        private readonly MonarchForePattern m_Fore;
        private readonly MonarchHindPattern m_Hind;
        private readonly MonotoneCurve m_Seam = MonotoneCurve.Straight(s_SeamSpans, s_SeamForward).Smoothed();

        /// <summary>Lays the pattern into an outline.</summary>
        public MonarchPattern(WingOutline outline)
        {
            m_Fore = new MonarchForePattern(outline);
            m_Hind = new MonarchHindPattern(outline);
        }

        /// <inheritdoc/>
        public override Color Underside => new Color(0.98f, 0.76f, 0.42f, 0.55f);

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double below = m_Seam.At(Math.Clamp(span, 0, 1)) - forward;
            float hind = Ink.Within(-below, 0, softness);
            Color colour = hind < 1f ? m_Fore.ColourAt(span, forward, softness) : default;
            if (hind > 0f)
            {
                double shadow = 1 - k_ShadowDepth * Ink.Fade(below, k_ShadowWidth);
                colour = Color.Lerp(colour, Ink.Lit(m_Hind.ColourAt(span, forward, softness), shadow), hind);
            }

            double half = Math.Max(k_SeamHalfWidth, MonarchColours.LeastFeature * softness);
            return Color.Lerp(colour, MonarchColours.Dark, Ink.Within(Math.Abs(below + half), half, softness));
        }
    }
}
