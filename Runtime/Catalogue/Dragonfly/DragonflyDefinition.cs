using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A dragonfly of the sizes that Azuma and Watanabe measured: four long clear wings, the hind ones broad at their base and ahead of the
    /// fore ones in the beat.
    /// </summary>
    internal static class DragonflyDefinition
    {
        private static readonly double[] s_ForeSpan = { 0, 2, 5, 10, 16, 22, 28, 34, 40, 45, 48, 49.5, 50 };
        private static readonly double[] s_HindSpan = { 0, 2, 5, 10, 16, 22, 28, 34, 39, 43.5, 46.5, 48, 48.5 };
        private static readonly double[] s_Leading = { 0.6, 1, 1.3, 1.6, 1.8, 1.9, 1.9, 1.8, 1.5, 0.9, 0.1, -0.9, -1.9 };
        private static readonly double[] s_ForeTrailing = { -1.2, -3.74, -6.23, -8.51, -9.65, -10.17, -10.38, -10.27, -9.55, -7.89, -6.02,
            -4.36, -3.11 };
        private static readonly double[] s_HindTrailing = { -1.4, -7.01, -11.19, -13.82, -14.01, -13.23, -12.26, -11.09, -9.63, -7.69,
            -5.74, -4.09, -2.92 };

        // Veins behind the arculus: the triangle of the fore wing, the loop of the hind wing.
        private static readonly double[] s_ForeTriangle = { 0.16, -0.035, 0.2, -0.02, 0.27, -0.052, 0.2, -0.085, 0.16, -0.035 };
        private static readonly double[] s_AnalLoop = { 0.13, -0.06, 0.17, -0.12, 0.21, -0.2, 0.19, -0.235, 0.155, -0.215, 0.12, -0.14,
            0.11, -0.07 };

        /// <summary>Distance of two cross veins, as a share of a vein.</summary>
        private const double k_Cell = 0.031;

        public static InsectDefinition Define()
        {
            WingDefinition fore = ForeWing();
            WingDefinition hind = HindWing();
            return new InsectDefinition("dragonfly", "Dragonfly", new[] { fore, hind }, DragonflyBody.Create(fore, hind), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0.3, 13, 3.6, 2.6, 2.8, 0.12),
                    BodyEllipsoid.Millimetres(0, -0.5, 1, 3.6, 4.4, 8, 0.58),
                    BodyEllipsoid.Millimetres(0, 0, -31, 1.5, 1.6, 26, 0.30),
                },
            };
        }

        private static WingDefinition ForeWing()
        {
            var outline = WingOutline.FromMillimetres(s_ForeSpan, s_Leading, s_ForeTrailing);
            return new WingDefinition("fore wing", outline, Author)
            {
                TriangleCount = 440,
                ChainPaths = ChainPath.Straight(0.462, 0.535, 0.61, 0.686, 0.757),
                Hinge = new Vector3(2.75e-3f, 1.6e-3f, 4.6e-3f),
                Pattern = Pattern(outline.Smoothed(), 0.48, s_ForeTriangle),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
        }

        private static WingDefinition HindWing()
        {
            var outline = WingOutline.FromMillimetres(s_HindSpan, s_Leading, s_HindTrailing);
            return new WingDefinition("hind wing", outline, AuthorHind)
            {
                TriangleCount = 520,
                ChainPaths = ChainPath.Straight(0.452, 0.538, 0.625, 0.71, 0.791),
                Hinge = new Vector3(2.9e-3f, 1.5e-3f, -1.6e-3f),
                Pattern = Pattern(outline.Smoothed(), 0.4, s_AnalLoop),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Carry);
        }

        private static WingPattern Pattern(WingOutline outline, double nodus, double[] ofItsOwn)
        {
            VeinFan veins = new VeinFan(outline, 0.75).Add(0.30, 0.41, 0.455, 0.49, 0.53, 0.575, 0.625, 0.69, 0.77, 0.86)
                .Fork(2, 0.66, 0.472).Fork(3, 0.6, 0.51).Fork(4, 0.55, 0.552).Fork(5, 0.5, 0.6).Fork(6, 0.45, 0.655).Fork(7, 0.5, 0.73)
                .Fork(8, 0.5, 0.815).Fork(4, 0.72, 0.541).Fork(5, 0.68, 0.588).Fork(6, 0.64, 0.64).Fork(7, 0.66, 0.71).Fork(8, 0.66, 0.795);
            for (int vein = 0; vein < 9; vein++)
            {
                double shift = k_Cell / 3 * (vein % 3);
                for (double at = 0.13; at < 0.97; at += k_Cell)
                    veins.Cross(vein, at + shift);
            }

            veins.Curve(ofItsOwn);

            return new MembranePattern(outline, veins)
            {
                Membrane = new Color(0.86f, 0.88f, 0.86f, 0.22f),
                Base = new Color(0.80f, 0.70f, 0.46f, 0.42f),
                Vein = new Color(0.13f, 0.11f, 0.10f, 0.96f),
                VeinHalfWidth = 0.0028,
                CostaHalfWidth = 0.0075,
                Stigma = new Vector2(0.845f, 0.905f),
                StigmaVein = 2,
                Nodus = nodus,
                Sheen = 0.35f,
            };
        }

        private static void Author(WingPreset preset)
        {
            preset.Size.wingLength = 0.050f;
            preset.Size.wingMass = 4.5e-6f;
            preset.Size.insectMass = 0.79e-3f;
            preset.Rest = new PresetRest { feet = new Vector3(0f, -9.5e-3f, 4e-3f), flap = 4f, sweep = -6f, feather = 8f };
            preset.Beat.maxFrequency = 29f;
            preset.Beat.frequencyFloor = 0.9f;
            preset.Beat.amplitudeFloor = 0.8f;
            preset.Beat.flapRange = 50f;
            preset.Beat.featherRange = 90f;
            preset.Beat.sweepRange = 0f;
            preset.Beat.meanFlap = 0f;
            preset.Beat.tilt = 35f;
            preset.Wave.chordDelay = 0f;
            preset.Wave.spanDelay = 0f;
            preset.Wave.rootShare = 1f;
            preset.Stiffness.elasticity = 4f;
        }

        private static void AuthorHind(WingPreset preset)
        {
            Author(preset);
            preset.Size.wingLength = 0.0485f;
            preset.Wave.chordDelay = 0.02f;
            preset.Rest.flap = 0f;
            preset.Rest.sweep = -4f;
            preset.Beat.flapRange = 52f;
            preset.Beat.featherRange = 60f;
            preset.Beat.tilt = 42f;
            preset.Beat.phaseLead = 61f;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.08f;
            preset.Wave.spanDelay = 0.3f;
            preset.Wave.rootShare = 0.8f;
            preset.Stiffness.elasticity = 1f;
        }

        private static void Fly(WingPreset preset)
        {
            Carry(preset);
            preset.Beat.flapRange = 72f;
        }

        private static void Carry(WingPreset preset)
        {
            FlightVariant.Apply(preset);
            preset.Beat.maxFrequency = 33.4f;
            preset.Beat.meanFlap = 12f;
        }

        private static InsectSource[] Sources()
        {
            const string flown = "Azuma and Watanabe 1988, J. exp. Biol. 137", second = "Azuma and Watanabe 1988, flight 2, rounded";
            return new[]
            {
                new InsectSource("wing length", "fore 50.0 mm, hind 48.5 mm", flown),
                new InsectSource("wing area", "fore 500 mm², hind 600 mm² each", flown),
                new InsectSource("wing outlines", "13 landmarks each", "drawn by us to the measured length and area"),
                new InsectSource("wing mass", "4.5 mg each", "Wakeling 1997, Odonatologica 26, Aeshna cyanea: about 9 mg a pair"),
                new InsectSource("insect mass, length", "790 mg, 75 mm", flown),
                new InsectSource("centre of mass", "0.14 of the length behind the fore wing's base",
                    "Wakeling 1997: 0.09 to 0.15; parts of the body chosen for it"),
                new InsectSource("MAX_f", "29 Hz, at least 26.1", "Azuma and Watanabe 1988: 26.5 to 29.0 Hz at 0.7 to 2.3 m/s"),
                new InsectSource("u_max", "2 m/s", "assumed: as the monarch's"),
                new InsectSource("MAX_a flap", "fore 50°, hind 52°", second),
                new InsectSource(
                    "MAX_a feather", "fore 90°, hind 60°", "Azuma and Watanabe 1988: first harmonics of 46 to 54° and 24 to 38°"),
                new InsectSource(
                    "tilt", "fore 35°, hind 42°", "Azuma and Watanabe 1988, flight 2: stroke planes of 55 and 48° from the horizontal"),
                new InsectSource("phase of the hind wing", "61° ahead", second),
                new InsectSource(
                    "λ, μ, w_0", "fore 0, hind 0.02; 0; 1", "chosen: the feather is driven at the root, and the veins are stiff"),
                new InsectSource("elasticity k_e", "4", "chosen: stiffer than a butterfly's"),
                new InsectSource("k_e, λ, μ, w_0", "1, 0.08, 0.3, 0.8", "chosen for the eye", InsectVariant.Expressive),
                new InsectSource("MAX_f", "33.4 Hz", "Wang and Russell 2007, Phys. Rev. Lett. 99:148101: a tethered Libellula pulchella",
                    InsectVariant.Flight),
                new InsectSource(
                    "MAX_a flap", "fore 72°, hind 52°", "Azuma and Watanabe 1988, flight 1, the slowest", InsectVariant.Flight),
                new InsectSource(
                    "middle of the stroke", "12° up",
                    "chosen: it brings the force of a tilted stroke back to the centre of mass, which lies 8 mm behind the "
                    + "middle of the hinges",
                    InsectVariant.Flight),
                new InsectSource("veins, colours", "ten veins, thirteen forks, cross veins, nodus, anal loop", "drawn by us"),
            };
        }
    }
}
