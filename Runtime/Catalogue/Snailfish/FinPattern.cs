using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A snailfish's fin, drawn for this package: jelly-like skin that light passes, stiffer rays that end free of it, blotches across them
    /// and a pale hem.
    /// </summary>
    internal sealed class FinPattern : WingPattern
    {
        private const double k_RayHalfWidth = 0.011, k_LeastFeature = 0.3, k_HemWidth = 0.035;
        private const double k_BlotchLength = 0.23, k_BlotchBend = 0.35;

        private static readonly Color s_Skin = new Color(0.93f, 0.72f, 0.66f, 0.55f);
        private static readonly Color s_Root = new Color(0.80f, 0.47f, 0.43f, 0.9f);
        private static readonly Color s_Ray = new Color(0.60f, 0.30f, 0.30f, 0.95f);
        private static readonly Color s_Blotch = new Color(0.66f, 0.38f, 0.40f, 0.8f);
        private static readonly Color s_Hem = new Color(0.98f, 0.87f, 0.82f, 0.5f);

        private readonly VeinFan m_Rays;
        private readonly StrokeSet m_Hem = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        /// <param name="rays">The rays.</param>
        public FinPattern(WingOutline outline, VeinFan rays)
        {
            m_Rays = rays;
            m_Hem.Add(Ink.Margin(outline, 0.1, 0.97));
        }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double ray = m_Rays.Distance(
                span, forward, out double along, Math.Max(k_RayHalfWidth, k_LeastFeature * softness) + Math.Max(softness, 0.008));
            double fromBase = Math.Sqrt(span * span + (forward + 0.09) * (forward + 0.09));
            var colour = Color.Lerp(s_Skin, s_Root, Ink.Within(fromBase, 0.15, 0.5));
            double waves = Math.Sin(2 * Math.PI * fromBase / k_BlotchLength) + k_BlotchBend * Math.Sin(9 * forward + 5 * span) - 0.45;
            colour = Color.Lerp(colour, s_Blotch, (float)Math.Clamp(waves, 0, 0.7));
            colour = Color.Lerp(colour, s_Hem, 0.8f * m_Hem.Line(span, forward, k_HemWidth, k_HemWidth));
            double width = Math.Max(k_RayHalfWidth * (1 - 0.55 * along), k_LeastFeature * softness);
            return Color.Lerp(colour, s_Ray, Ink.Within(ray, width, Math.Max(softness, 0.008)));
        }
    }
}
