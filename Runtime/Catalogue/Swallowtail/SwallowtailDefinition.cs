using Alate.Flight;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail of the kind of Papilio. It flies mainly by its fore wings; the tailed hind wings follow with a smaller amplitude, a
    /// little later, so that the wave runs on from the fore to the hind wing and its front edge stays beneath the fore wing's rear edge.
    /// </summary>
    internal static class SwallowtailDefinition
    {
        private static readonly double[] s_ForeSpan = { 0, 4, 9, 15, 21, 26.5, 30.5, 33.5, 37, 40.5, 43, 44.4, 45 };
        private static readonly double[] s_ForeLeading = { 0.8, 3.2, 5.8, 8.6, 11.2, 13.4, 14.8, 15.7, 16.5, 16.9, 16.6, 15.9, 15.0 };
        private static readonly double[] s_ForeTrailing = { -1.2, -2.6, -3.9, -5.2, -6.4, -7.2, -7.4, -5.8, -0.6, 5.6, 9.9, 12.2, 13.4 };

        private static readonly double[] s_HindSpan = { 0, 1.2, 3, 6, 9.5, 12.5, 15.5, 17.6, 18.8, 19.8, 20.8, 21.8, 22.8, 24.2, 26.5, 29,
            31.4, 33.2, 34 };

        private static readonly double[] s_HindLeading = { 0.6, 1.4, 2.0, 2.2, 2.0, 1.6, 1.0, 0.5, 0.2, -0.1, -0.4, -0.8, -1.1, -1.7, -2.8,
            -4.4, -6.4, -8.8, -10.4 };

        private static readonly double[] s_HindTrailing =
        {
            -1.8, -7.0, -15.5, -24.5, -30.5, -32.8, -33.0, -34.6, -40.0, -45.4,
            -47.0, -45.8, -39.0, -32.6, -28.6, -24.2, -19.4, -15.0, -12.2,
        };

        /// <summary>The middle of the tail's root, wing lengths: the chain of the tail goes through it.</summary>
        private static readonly PlanPoint s_TailRoot = new PlanPoint(0.597, -0.955);

        // Assumed: a monarch's.
        private const float k_Swing = 13.8f, k_LowestPhase = 42f;

        public static InsectDefinition Define()
        {
            WingDefinition fore = ForeWing();
            WingDefinition hind = HindWing();
            return new InsectDefinition("swallowtail", "Swallowtail", new[] { fore, hind }, SwallowtailBody.Create(fore, hind), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 5.6, 1.4, 1.4, 1.4, 0.08),
                    BodyEllipsoid.Millimetres(0, 0, 0, 2.2, 2.5, 4.8, 0.40),
                    BodyEllipsoid.Millimetres(0, -0.8, -11, 1.75, 1.8, 8.6, 0.52).Swinging(k_Swing, k_LowestPhase),
                },
            };
        }

        private static WingDefinition ForeWing()
        {
            var outline = WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing);
            return new WingDefinition("fore wing", outline, AuthorFore)
            {
                TriangleCount = 960,
                ChainPaths = ChainPath.Straight(0.46, 0.52, 0.58, 0.64, 0.71),
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.1e-3f),
                Pattern = new SwallowtailForePattern(outline.Smoothed()),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
        }

        private static WingDefinition HindWing()
        {
            var outline = WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing);
            return new WingDefinition("hind wing", outline, AuthorHind)
            {
                TriangleCount = 1440,
                JointsPerChain = 6,
                ChainPaths = new[]
                {
                    new ChainPath(0.28), new ChainPath(0.36), new ChainPath(0.44), new ChainPath(0.5945, s_TailRoot), new ChainPath(0.745),
                    new ChainPath(0.82),
                },
                Hinge = new Vector3(2.1e-3f, 0.8e-3f, -1.4e-3f),
                Pattern = new SwallowtailHindPattern(outline.Smoothed()),
            }.With(InsectVariant.Expressive, SoftenHind).With(InsectVariant.Flight, Fly);
        }

        private static void AuthorFore(WingPreset preset)
        {
            preset.Size.wingLength = 0.045f;
            preset.Size.wingMass = 12.4e-6f;
            preset.Size.insectMass = 0.45e-3f;
            preset.Rest = new PresetRest { feet = new Vector3(0f, -6.5e-3f, 0f), flap = 88.5f, sweep = -10f };
            preset.Beat.flapRange = 116f;
            preset.Beat.featherRange = 16f;
            preset.Beat.meanFlap = 12f;
            preset.Wave.chordDelay = 0.1f;
        }

        private static void AuthorHind(WingPreset preset)
        {
            AuthorFore(preset);
            preset.Size.wingLength = 0.034f;
            preset.Size.wingMass = 18.4e-6f;
            preset.Rest.flap = 86f;
            preset.Beat.flapRange = 110f;
            preset.Beat.featherRange = 10f;
            preset.Beat.meanFlap = 7f;
            preset.Beat.phaseLead = -24f;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.14f;
            preset.Wave.spanDelay = 0.2f;
            preset.Wave.rootShare = 0.7f;
            preset.Stiffness.elasticity = 0.45f;
            preset.Stiffness.decay = 0.6f;
            preset.Stiffness.springScale = 30f;
            preset.SubstepsPerBeat = 24;
        }

        private static void SoftenHind(WingPreset preset)
        {
            Soften(preset);
            preset.Beat.meanFlap = 6.5f;
            preset.Beat.phaseLead = -27f;
        }

        private static void Fly(WingPreset preset)
        {
            const float larger = 55f / 45f;
            FlightVariant.Apply(preset);
            preset.Beat.maxFrequency = 14f;
            preset.Size.wingLength *= larger;
            preset.Rest.feet *= larger;
            preset.Size.wingMass *= larger * larger;
            preset.Size.insectMass = 0.34e-3f;
        }

        private static InsectSource[] Sources()
        {
            const InsectVariant expressive = InsectVariant.Expressive;
            return new[]
            {
                new InsectSource("wing length", "fore 45 mm, hind 34 mm across and 49 mm down to the tail",
                    "assumed: a large Papilio; proportions chosen by us"),
                new InsectSource("wing outlines", "13 and 19 landmarks, 6.3 and 9.3 cm²", "proportions chosen by us"),
                new InsectSource("wing mass", "fore 12.4 mg, hind 18.4 mg", "assumed: 19.8 g/m², as a monarch's wings"),
                new InsectSource("insect mass", "0.45 g", "assumed: about a monarch's"),
                new InsectSource("MAX_f", "11 Hz", "the paper, Sec. 5.1"),
                new InsectSource("u_max", "2 m/s", "assumed: as the monarch's"),
                new InsectSource("MAX_a flap", "fore 116°, hind 110°", "assumed: within the 84 to 148° measured on butterflies; the hind "
                    + "wing beats with the smaller amplitude (the paper, Sec. 7.1)"),
                new InsectSource("MAX_a feather, sweep", "fore 16°, 36°; hind 10°, 36°",
                    "assumed: the monarch's sweep; less feather, so that the wings' edges stay together"),
                new InsectSource("middle of the stroke", "fore 12°, hind 7°", "chosen so that the hind wing meets the fore wing at the "
                    + "bottom and stays beneath it above, by less than 13 % of the span"),
                new InsectSource("phase of the hind wing", "24° later",
                    "chosen so that the hind wing's front edge moves with the fore wing's rear edge"),
                new InsectSource("elasticity k_e", "1", "assumed: the monarch's of Table 2"),
                new InsectSource("triangles", "4800 on four wings", "chosen: about the density of the monarch's mesh"),
                new InsectSource("chord delay λ", "0.1",
                    "chosen: over both wings the rear edge lags by some 40°, the upper end of what is expected, not measured"),
                new InsectSource("k_e, λ, μ, w_0, decay, κ", "0.45, 0.14, 0.2, 0.7, 0.6, 30",
                    "chosen for the eye: wings that bow and tails that trail", expressive),
                new InsectSource(
                    "hind wing's middle and phase", "6.5°, 27° later", "chosen: the softer edges stay together with these", expressive),
                new InsectSource("MAX_f", "14 Hz", "chosen: the beat at which these wings carry the insect", InsectVariant.Flight),
                new InsectSource("wing lengths", "fore 55 mm, hind 41.6 mm; masses with the square of the length",
                    "chosen: a large Papilio", InsectVariant.Flight),
                new InsectSource("insect mass", "0.34 g", "chosen: a slender male", InsectVariant.Flight),
                new InsectSource("abdomen's swing", "±13.8°, lowest at 42° of the beat", "assumed: that of a monarch"),
                new InsectSource("colours", "yellow and black", "drawn by us"),
            };
        }
    }
}
