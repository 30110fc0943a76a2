using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A clear wing: a tinted membrane that lets things behind it show through, and opaque veins that thin out towards the margin. Opacity
    /// is in the colour's alpha; a material that ignores alpha shows a pale membrane.
    /// </summary>
    internal sealed class MembranePattern : WingPattern
    {
        private const double k_LeastFeature = 0.3, k_RimWidth = 0.008, k_ThinnestShare = 0.45, k_CrossShare = 0.6, k_Stem = 0.1;

        private readonly VeinFan m_Veins;
        private readonly StrokeSet m_Rim = new StrokeSet();
        private readonly StrokeSet m_Costa = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        /// <param name="veins">The veins.</param>
        public MembranePattern(WingOutline outline, VeinFan veins)
        {
            m_Veins = veins;
            m_Rim.Add(Ink.Margin(outline, 0, 1));
            m_Costa.Add(Ink.Margin(outline, 0, 0.47));
        }

        /// <summary>Colour of the membrane; alpha is its opacity.</summary>
        public Color Membrane { get; set; }

        /// <summary>Colour of the membrane near the base.</summary>
        public Color Base { get; set; }

        /// <summary>Colour of veins and margin.</summary>
        public Color Vein { get; set; }

        /// <summary>Half width of a vein near the base, wing lengths.</summary>
        public double VeinHalfWidth { get; set; } = 0.006;

        /// <summary>Half width of the thickened leading edge.</summary>
        public double CostaHalfWidth { get; set; } = 0.014;

        /// <summary>Strength of the pale and dark dapples along the veins, 0 to 1.</summary>
        public float Dapple { get; set; }

        /// <summary>Distance from one dapple to the next, wing lengths.</summary>
        public double DappleLength { get; set; } = 0.05;

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double fromBase = Math.Sqrt(span * span + forward * forward);
            var colour = Color.Lerp(Membrane, Base, Ink.Within(fromBase, k_Stem, 2 * k_Stem));
            double reach = Dapple > 0f ? double.MaxValue : Math.Max(VeinHalfWidth, k_LeastFeature * softness) + softness;
            double vein = m_Veins.Distance(span, forward, out double along, reach);
            if (Dapple > 0f)
            {
                double wave = Math.Sin(2 * Math.PI * fromBase / DappleLength)
                    + Math.Sin(2 * Math.PI * (span - 1.3 * forward) / (1.7 * DappleLength));
                float dark = (float)(Math.Clamp(0.6 * wave - 0.1, 0, 1) * Math.Exp(-Math.Pow(vein / (3 * VeinHalfWidth), 2)));
                colour = Color.Lerp(colour, Vein, Dapple * dark);
            }

            double taper = Math.Min(k_ThinnestShare + 2.5 * along, Math.Max(k_ThinnestShare, 1 - 0.6 * along));
            double width = Math.Max(VeinHalfWidth * taper, k_LeastFeature * softness);
            double cross = Math.Max(k_CrossShare * VeinHalfWidth, k_LeastFeature * softness);
            float drawn = Math.Max(Ink.Within(vein, width, softness), m_Veins.CrossVeins(span, forward, cross, softness));
            drawn = Math.Max(drawn, m_Rim.Line(span, forward, k_RimWidth, softness));
            drawn = Math.Max(drawn, Ink.Within(m_Costa.Distance(span, forward, out double ahead, CostaHalfWidth + softness),
                CostaHalfWidth * (1 - 0.7 * ahead), softness));
            return Color.Lerp(colour, Vein, drawn);
        }
    }
}
