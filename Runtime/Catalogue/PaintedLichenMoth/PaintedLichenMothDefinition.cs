using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// The painted lichen moth, Hypoprepia fucosa. Its fore and hind wing are hooked to each other and are one wing here, as the monarch's
    /// are.
    /// </summary>
    internal static class PaintedLichenMothDefinition
    {
        private static readonly double[] s_Span = { 0, 0.9, 2.0, 3.6, 4.9, 6.1, 7.3, 8.4, 9.4, 10.3, 11.0, 11.9, 12.9, 14.0 };
        private static readonly double[] s_Leading = { 0.25, 0.7, 1.25, 1.95, 2.45, 2.86, 3.2, 3.44, 3.6, 3.7, 3.76, 3.78, 3.7, 3.45 };
        private static readonly double[] s_Trailing =
            { -0.6, -2.9, -5.1, -7.1, -7.85, -8.0, -7.8, -7.15, -6.05, -4.4, -2.75, -2.05, -1.55, -1.05 };

        public static InsectDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            WingDefinition wing = new WingDefinition("wing", outline, Author)
            {
                TriangleCount = 824,
                ChainPaths = ChainPath.Straight(0.39, 0.425, 0.503, 0.594, 0.78),
                Hinge = new Vector3(1.15e-3f, 0.6e-3f, 0.7e-3f),
                Pattern = new LichenMothPattern(outline.Smoothed()),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
            return new InsectDefinition(
                "painted-lichen-moth", "Painted lichen moth", new[] { wing }, PaintedLichenMothBody.Create(wing), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 0, 1.2, 1.15, 2.6, 0.5),
                    BodyEllipsoid.Millimetres(0, -0.2, -4, 1, 0.9, 2.8, 0.5),
                },
            };
        }

        private static void Author(WingPreset preset)
        {
            preset.Size.wingLength = 0.014f;
            preset.Size.wingMass = 0.84e-6f;
            preset.Size.insectMass = 25e-6f;
            preset.Rest =
                new PresetRest { feet = new Vector3(0f, -3.2e-3f, -0.4e-3f), flap = -25f, sweep = -80f, feather = 80f, tilt = -10f };
            preset.Beat.flapRange = 126f;
            preset.Beat.featherRange = 37f;
            preset.Beat.sweepRange = 37f;
            preset.Stiffness.elasticity = 1.8f;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.28f;
            preset.Wave.spanDelay = 0.35f;
            preset.Wave.rootShare = 0.55f;
            preset.Stiffness.elasticity = 0.28f;
            preset.Stiffness.decay = 0.35f;
            preset.Stiffness.jointLimit = 40f;
            preset.Stiffness.springScale = 60f;
            preset.SubstepsPerBeat = 24;
        }

        private static void Fly(WingPreset preset)
        {
            FlightVariant.Apply(preset);
            preset.Beat.maxFrequency = 39f;
        }

        private static InsectSource[] Sources()
        {
            const InsectVariant expressive = InsectVariant.Expressive;
            return new[]
            {
                new InsectSource("wing length", "14 mm", "from a wing span of 25 to 35 mm, Forbes 1960"),
                new InsectSource("wing outline", "14 landmarks of the fore and hind wing couple, 1.07 cm²", "proportions chosen by us"),
                new InsectSource("wing mass", "0.84 mg a couple", "assumed: ρ* of 4, 7.9 g/m² of scaled membrane"),
                new InsectSource("insect mass", "25 mg", "assumed: a body of 11 mm"),
                new InsectSource("MAX_f", "11 Hz", "the paper, Sec. 5.1, for all insects"),
                new InsectSource("u_max", "2 m/s", "assumed: as the monarch's"),
                new InsectSource("MAX_a flap, feather, sweep", "126°, 37°, 37°", "the paper, Table 1"),
                new InsectSource("elasticity k_e", "1.8", "the paper, Table 2"),
                new InsectSource("triangles", "1648 on two wings", "the paper, Table 2"),
                new InsectSource("chord delay λ", "0.15", "chosen: a lag of some 20°, within the 10 to 40° expected, not measured"),
                new InsectSource(
                    "k_e, λ, μ, w_0, decay, joint limit, κ", "0.28, 0.28, 0.35, 0.55, 0.35, 40°, 60",
                    "chosen for the eye: tips that cup, as in the paper's Fig. 12", expressive),
                new InsectSource("MAX_f", "39 Hz", "chosen: the beat at which these wings carry 25 mg; small moths beat at 30 to 60 Hz",
                    InsectVariant.Flight),
                new InsectSource(
                    "colours", "two grey stripes on yellow, red between them, a pink hind wing",
                    "after photographs of the species, drawn by us"),
            };
        }
    }
}
