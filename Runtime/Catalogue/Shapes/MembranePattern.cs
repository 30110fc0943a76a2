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
        private const double k_LeastFeature = 0.3, k_RimWidth = 0.008, k_ThinnestShare = 0.45, k_CrossShare = 0.6, k_Stem = 0.1,
            k_StigmaSlant = 0.6, k_KnotSlant = 0.7, k_KnotDepth = 0.045, k_KnotLength = 0.016,
            k_BeadStart = 0.25, k_BeadSlant = 0.6;

        private static readonly Color s_Pink = new Color(0.93f, 0.66f, 0.78f);
        private static readonly Color s_Green = new Color(0.62f, 0.90f, 0.76f);
        private static readonly Color s_Bead = new Color(0.86f, 0.80f, 0.62f, 0.95f);

        private readonly WingOutline m_Outline;
        private readonly VeinFan m_Veins;
        private readonly StrokeSet m_Rim = new StrokeSet();
        private readonly StrokeSet m_Costa = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        /// <param name="veins">The veins.</param>
        public MembranePattern(WingOutline outline, VeinFan veins)
        {
            m_Outline = outline;
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

        /// <summary>Strength of the pale beads into which the veins are divided, 0 to 1.</summary>
        public float Beads { get; set; }

        /// <summary>Distance from one bead to the next, wing lengths.</summary>
        public double BeadLength { get; set; } = 0.018;

        /// <summary>Spans between which a cell behind the leading edge is dark, the pterostigma; none where both are 0.</summary>
        public Vector2 Stigma { get; set; }

        /// <summary>Number of the vein at which that cell ends.</summary>
        public int StigmaVein { get; set; }

        /// <summary>Span at which the leading edge is notched and a strong cross vein meets it, the nodus; 0 for none.</summary>
        public double Nodus { get; set; }

        /// <summary>Strength of the sheen of thin films, pink and green by turns, 0 to 1.</summary>
        public float Sheen { get; set; }

        /// <inheritdoc/>
        public override Color ColourAt(double span, double forward, double softness)
        {
            double fromBase = Math.Sqrt(span * span + forward * forward);
            var colour = Color.Lerp(Membrane, Base, Ink.Within(fromBase, k_Stem, 2 * k_Stem));
            if (Sheen > 0f)
                colour = Sheened(colour, span, forward);
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
            float veins = Ink.Within(vein, width, softness), drawn = m_Veins.CrossVeins(span, forward, cross, softness);
            drawn = Math.Max(drawn, m_Rim.Line(span, forward, k_RimWidth, softness));
            drawn = Math.Max(drawn, Ink.Within(m_Costa.Distance(span, forward, out double ahead, CostaHalfWidth + softness),
                CostaHalfWidth * (1 - 0.7 * ahead), softness));
            if (Stigma.y > 0f)
                drawn = Math.Max(drawn, 0.9f * Marked(span, forward, softness));
            if (Nodus > 0.0)
                drawn = Math.Max(drawn, Knot(span, forward, softness));
            if (Beads > 0f && veins > drawn)
                return Color.Lerp(colour, Beaded(fromBase, forward, softness), veins);
            return Color.Lerp(colour, Vein, Math.Max(veins, drawn));
        }

        // Dark at the base, where veins lie side by side; from there on beads of neighbours are beside each other by chance.
        private Color Beaded(double fromBase, double forward, double softness)
        {
            double bead = (fromBase + k_BeadSlant * forward) / BeadLength, beside = Math.Abs(bead - Math.Round(bead)) * BeadLength;
            float pale = Ink.Within(beside, 0.25 * BeadLength, softness + 0.1 * BeadLength)
                * Ink.Within(-fromBase, -k_BeadStart, k_BeadStart);
            return Color.Lerp(Vein, s_Bead, Beads * pale);
        }

        // Its ends lie at a slant, as the cross veins do that end it.
        private float Marked(double span, double forward, double softness)
        {
            double along = Math.Clamp(span, 0, 1), behind = m_Outline.LeadingAt(along) - forward;
            float cell = Ink.Between(span + k_StigmaSlant * behind, Stigma.x, Stigma.y, softness);
            return cell > 0f ? cell * Ink.Within(m_Veins.ForwardOf(StigmaVein, along) - forward, 0, softness) : 0f;
        }

        private float Knot(double span, double forward, double softness)
        {
            double behind = m_Outline.LeadingAt(Math.Clamp(span, 0, 1)) - forward;
            float cross = Ink.Within(Math.Abs(span - Nodus + k_KnotSlant * behind), 1.6 * VeinHalfWidth, softness)
                * Ink.Within(behind, k_KnotDepth, softness);
            return Math.Max(cross, Ink.Ellipse(span - Nodus, behind, k_KnotLength, 1.8 * CostaHalfWidth, softness));
        }

        // Thin films turn from pink to green with their thickness, which varies from the base to the margin.
        private Color Sheened(Color colour, double span, double forward)
        {
            float turn = (float)Math.Sin(2 * Math.PI * (2.3 * span + 3.1 * forward + 0.35 * Math.Sin(9 * span)));
            Color film = turn > 0f ? s_Pink : s_Green;
            film.a = colour.a;
            return Color.Lerp(colour, film, Sheen * Math.Abs(turn));
        }
    }
}
