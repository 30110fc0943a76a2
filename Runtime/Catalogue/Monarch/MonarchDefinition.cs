using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// The monarch, Danaus plexippus. Its fore and hind wing move as one (Dudley 2002) and are one wing here, as in the paper.
    /// </summary>
    internal static class MonarchDefinition
    {
        private const double k_LastTipSpan = 26.9;

        // Lowest 23° after the wing is highest, and the middle of this wing follows its drive by 19° in level flight at 1.3 m/s.
        private const float k_Swing = 13.8f, k_LowestPhase = 42f;

        private static readonly double[] s_Span = { 0, 4.5, 9.0, 13.4, 17.9, 22.4, 26.9, 31.3, 35.8, 40.3, 44.8, 49.2, 53.7, 58.2, 61.0 };
        private static readonly double[] s_Leading = { 0.3, 2.3, 4.0, 5.3, 6.6, 7.7, 8.8, 9.7, 10.3, 10.7, 10.8, 10.8, 10.9, 9.6, 7.6 };

        private static readonly double[] s_Trailing =
        {
            -1.4, -4.6, -9.3, -14.4, -19.6, -24.7, -27.8, -25.4, -21.1, -16.1, -8.1, -4.6, -1.8, 2.2, 4.3,
        };

        public static InsectDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            WingDefinition wing = new WingDefinition("wing", outline, _ => { })
            {
                TriangleCount = 2096,
                IsFilled = false,
                LastTipSpan = k_LastTipSpan / (1000 * outline.Length),
                Hinge = new Vector3(1.9e-3f, 1.0e-3f, 1.2e-3f),
                Pattern = new MonarchPattern(outline.Smoothed()),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
            return new InsectDefinition("monarch", "Monarch", new[] { wing }, MonarchBody.Create(wing), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 5.4, 1.4, 1.4, 1.4, 0.08),
                    BodyEllipsoid.Millimetres(0, 0, 0, 2.1, 2.4, 4.5, 0.38),
                    BodyEllipsoid.Millimetres(0, -0.8, -12, 1.6, 1.7, 10, 0.54).Swinging(k_Swing, k_LowestPhase),
                },
            };
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.22f;
            preset.Wave.spanDelay = 0.25f;
            preset.Wave.rootShare = 0.65f;
            preset.Stiffness.elasticity = 0.35f;
            preset.Stiffness.decay = 0.5f;
            preset.Stiffness.springScale = 30f;
            preset.SubstepsPerBeat = 24;
        }

        private static void Fly(WingPreset preset) => FlightVariant.Apply(preset);

        private static InsectSource[] Sources()
        {
            const string measured = "Kang, Sridhar et al. 2020, measured on monarchs";
            return new[]
            {
                new InsectSource("wing length", "61.0 mm", measured),
                new InsectSource("wing outline", "15 landmarks of the fore and hind wing couple, 12.7 cm²", measured + ", rounded"),
                new InsectSource("wing mass", "25.1 mg a couple", measured),
                new InsectSource("insect mass", "0.428 g", measured),
                new InsectSource("MAX_f", "11 Hz", "the paper, Sec. 5.1, after Davenport 1994 and Kang et al. 2018"),
                new InsectSource("u_max", "2 m/s", "assumed: a brisk cruise of a monarch"),
                new InsectSource(
                    "MAX_a flap, feather, sweep", "120°, 24°, 36°", "the paper, Table 1; read from end to end, as the measured ±60° asks"),
                new InsectSource("elasticity k_e", "1", "the paper, Table 2"),
                new InsectSource("triangles", "4192 on two wings", "the paper, Table 2"),
                new InsectSource("chord delay λ", "0.15",
                    "chosen so that the trailing edge lags by some 27°, within the 10 to 40° expected, not measured"),
                new InsectSource("k_e, λ, μ, w_0, decay, κ", "0.35, 0.22, 0.25, 0.65, 0.5, 30",
                    "chosen for the eye: wings that bow and roll", InsectVariant.Expressive),
                new InsectSource("last chain's tip", "span 26.9 mm", "chosen: the rearmost point of the hind wing"),
                new InsectSource("body", "ellipsoids of head, thorax and abdomen, 8, 38 and 54 % of its mass",
                    "chosen: proportions of a monarch", InsectVariant.Flight),
                new InsectSource("abdomen's swing", "±13.8°, lowest 23° of the beat after the wing is highest",
                    "Tejaswi, Sridhar, Kang and Lee 2021, measured on a monarch; 19° later by the drive of this wing"),
                new InsectSource("body, colours", "29 mm long, thorax 4.5 mm wide", "proportions chosen by us"),
            };
        }
    }
}
