using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail's fore wing, drawn for this package: yellow between black veins, a dusky base, bars across the cell and a black border
    /// with yellow spots.
    /// </summary>
    internal sealed class SwallowtailForePattern : WingPattern
    {
        private const double k_VeinHalfWidth = 0.0045, k_LeastFeature = 0.35, k_BorderWidth = 0.155, k_Scallop = 0.014,
            k_SpotSpacing = 0.082;
        private const double k_CostaWidth = 0.014, k_Beyond = 0.3, k_LastSpot = 0.57;

        private static readonly double[][] s_Bars =
        {
            new[] { 0.36, 0.215, 0.385, 0.13 },
            new[] { 0.53, 0.29, 0.55, 0.20 },
            new[] { 0.60, 0.315, 0.615, 0.26 },
        };

        private readonly VeinFan m_Veins;
        private readonly StrokeSet m_Border = new StrokeSet();
        private readonly StrokeSet m_Costa = new StrokeSet();
        private readonly StrokeSet m_Bars = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        public SwallowtailForePattern(WingOutline outline)
        {
            m_Border.Add(Ink.Extended(Ink.Margin(outline, 0.465, 0.68), k_Beyond), -k_Beyond);
            m_Costa.Add(Ink.Margin(outline, 0, 0.46));
            m_Costa.Add(Ink.Margin(outline, 0.70, 1));
            m_Veins = new VeinFan(outline, 0.45).Add(0.43, 0.475, 0.515, 0.555, 0.595, 0.635, 0.675, 0.77).Cross(1, 0.62).Cross(2, 0.6)
                .Cross(3, 0.57).Cross(4, 0.52);
            foreach (double[] bar in s_Bars)
                m_Bars.Add(bar);
        }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double fromBase = Math.Sqrt(span * span + forward * forward);
            var colour = Color.Lerp(SwallowtailColours.Yellow, SwallowtailColours.Pale, Ink.Within(-span, -0.55, 0.4));
            colour = Color.Lerp(colour, SwallowtailColours.Dusk, Ink.Within(fromBase, 0.2, 0.12));
            double vein = Math.Max(k_VeinHalfWidth, k_LeastFeature * softness);
            float dark = m_Veins.Veins(span, forward, vein, softness);
            dark = Math.Max(dark, m_Veins.CrossVeins(span, forward, vein, softness));
            dark = Math.Max(dark, m_Costa.Line(span, forward, k_CostaWidth, softness));
            dark = Math.Max(dark, m_Bars.Line(span, forward, 0.016, softness));
            double edge = m_Border.Distance(span, forward, out double along, k_BorderWidth + k_Scallop + softness);
            double border = k_BorderWidth + k_Scallop * Math.Cos(2 * Math.PI * along / k_SpotSpacing);
            colour = Color.Lerp(colour, SwallowtailColours.Black, Math.Max(dark, Ink.Within(edge, border, softness)));
            float spots = Ink.Row(along, edge, k_SpotSpacing, 0.052, 0.027, 0.017, softness) * Ink.Between(along, 0, k_LastSpot, softness);
            return Color.Lerp(colour, SwallowtailColours.Yellow, spots);
        }
    }
}
