using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Colours and strokes that a swallowtail's fore and hind wings share.</summary>
    internal static class SwallowtailColours
    {
        public static readonly Color Yellow = new Color(0.96f, 0.80f, 0.33f);
        public static readonly Color Black = new Color(0.085f, 0.07f, 0.065f);
        public static readonly Color Blue = new Color(0.30f, 0.44f, 0.78f);
        public static readonly Color Underside = new Color(0.98f, 0.93f, 0.72f, 0.5f);
        public static readonly Color Red = new Color(0.80f, 0.26f, 0.13f);

        private const double k_VeinHalfWidth = 0.0046, k_LeastFeature = 0.35, k_Beside = 0.014, k_GrainSize = 0.005, k_Creep = 0.045,
            k_CreepReach = 0.03;

        private const float k_Grain = 0.045f;

        private static readonly Color s_Pale = new Color(0.97f, 0.87f, 0.52f);
        private static readonly Color s_Ochre = new Color(0.80f, 0.60f, 0.18f);

        /// <summary>Yellow ground, paler towards the tip, ochre beside veins, with the grain of its scales.</summary>
        public static Color Ground(double towardsTip, double vein, double span, double forward, double softness)
        {
            var colour = Color.Lerp(Yellow, s_Pale, Ink.Within(-towardsTip, -0.55, 0.5));
            colour = Color.Lerp(colour, s_Ochre, 0.5f * Ink.Within(vein, k_Beside, 2 * k_Beside));
            return Ink.Lit(colour, 1 + k_Grain * Ink.Grain(span, forward, k_GrainSize, softness));
        }

        /// <summary>Colour with scales of another one strewn over it: few where the share is small, all of it where it is 1.</summary>
        public static Color Dusted(Color colour, Color dust, float share, double span, double forward, double softness)
        {
            float grain = Ink.Grain(span, forward, 0.8 * k_GrainSize, softness);
            float strewn = Math.Clamp(share + share * (1f - share) * 2.5f * grain, 0f, 1f);
            return Color.Lerp(colour, dust, strewn);
        }

        /// <summary>Share of a vein at a distance from it.</summary>
        public static float Vein(double distance, double softness) =>
            Ink.Within(distance, Math.Max(k_VeinHalfWidth, k_LeastFeature * softness), softness);

        /// <summary>Reach to which the distance of a vein counts.</summary>
        public static double VeinReach(double softness) => Math.Max(2 * k_Beside, k_CreepReach) + softness;

        /// <summary>Reach to which the distance of a border of a width counts.</summary>
        public static double BorderReach(double width, double softness) => width + k_Creep + 2 * softness + k_Beside;

        /// <summary>Width of a border that creeps along the veins, so that it is an arc in each cell.</summary>
        public static double Scalloped(double width, double vein) => width + k_Creep * Ink.Fade(vein, k_CreepReach);
    }
}
