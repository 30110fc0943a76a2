using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>A fishfly of the kind of Chauliodes: four long wings of one beat, that do not overlap when spread.</summary>
    internal static class FishflyDefinition
    {
        private static readonly double[] s_ForeSpan = { 0, 2.5, 6, 12, 18, 24, 29, 33, 35.6, 37.0, 37.6 };
        private static readonly double[] s_ForeLeading = { 0.6, 1.5, 2.4, 3.7, 4.9, 6.0, 6.6, 6.4, 5.5, 4.2, 3.1 };
        private static readonly double[] s_ForeTrailing = { -1.5, -2.6, -3.5, -4.4, -4.9, -4.8, -4.1, -2.7, -1.1, 0.3, 1.4 };
        private static readonly double[] s_HindSpan = { 0, 1.6, 4, 8, 13, 18, 23, 28, 31.4, 33.2, 34 };
        private static readonly double[] s_HindLeading = { 0.5, 0.6, 0.5, 0.1, -0.4, -1.0, -1.8, -3.0, -4.4, -5.8, -6.8 };
        private static readonly double[] s_HindTrailing = { -1.8, -5.6, -9.2, -11.6, -12.4, -12.4, -12.0, -11.0, -9.6, -8.2, -7.2 };

        public static InsectDefinition Define()
        {
            WingDefinition fore = ForeWing();
            WingDefinition hind = HindWing();
            return new InsectDefinition("fishfly", "Fishfly", new[] { fore, hind }, FishflyBody.Create(fore, hind), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 5, 2, 1.5, 2, 0.12),
                    BodyEllipsoid.Millimetres(0, 0, 0, 2.4, 2.3, 5.5, 0.42),
                    BodyEllipsoid.Millimetres(0, -0.9, -11.7, 1.6, 1.3, 8.3, 0.46),
                },
            };
        }

        private static WingDefinition ForeWing()
        {
            var outline = WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing);
            return new WingDefinition("fore wing", outline, Author)
            {
                TriangleCount = 296,
                ChainPaths = ChainPath.Straight(0.46, 0.516, 0.592, 0.703, 0.789),
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.8e-3f),
                Pattern = Pattern(outline.Smoothed()),
            }.With(InsectVariant.Biological, Steady).With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
        }

        private static WingDefinition HindWing()
        {
            var outline = WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing);
            return new WingDefinition("hind wing", outline, AuthorHind)
            {
                TriangleCount = 309,
                ChainPaths = ChainPath.Straight(0.44, 0.498, 0.59, 0.68, 0.816),
                Hinge = new Vector3(2.1e-3f, 1.2e-3f, -2.2e-3f),
                Pattern = Pattern(outline.Smoothed()),
            }.With(InsectVariant.Biological, SteadyAndLate).With(InsectVariant.Expressive, SoftenHind).With(InsectVariant.Flight, Fly);
        }

        private static WingPattern Pattern(WingOutline outline)
        {
            VeinFan veins = new VeinFan(outline, 0.6).Add(0.40, 0.45, 0.48, 0.515, 0.56, 0.61, 0.67, 0.74, 0.82)
                .Fork(2, 0.7, 0.497).Fork(3, 0.62, 0.538).Fork(4, 0.6, 0.585).Fork(5, 0.6, 0.64).Fork(6, 0.6, 0.705).Fork(7, 0.55, 0.78);
            for (int vein = 0; vein < 8; vein++)
            {
                double shift = 0.03 * (vein % 3);
                veins.Cross(vein, 0.3 + shift, 0.44 + shift, 0.57 + shift, 0.7 + shift, 0.82 + shift);
            }

            veins.Ladder(18);
            return new MembranePattern(outline, veins)
            {
                Membrane = new Color(0.80f, 0.77f, 0.70f, 0.45f),
                Base = new Color(0.66f, 0.60f, 0.50f, 0.6f),
                Vein = new Color(0.33f, 0.26f, 0.20f, 0.95f),
                VeinHalfWidth = 0.0045,
                CostaHalfWidth = 0.010,
                Sheen = 0.12f,
                Dapple = 0.6f,
                Beads = 0.75f,
            };
        }

        private static void Author(WingPreset preset)
        {
            preset.Size.wingLength = 0.0376f;
            preset.Size.wingMass = 3.62e-6f;
            preset.Size.insectMass = 0.2e-3f;
            preset.Rest =
                new PresetRest { feet = new Vector3(0f, -6.5e-3f, -1e-3f), flap = -20f, sweep = -84f, feather = 66f, tilt = -10f };
            preset.Beat.flapRange = 120f;
            preset.Beat.featherRange = 24f;
            preset.Beat.sweepRange = 0f;
            preset.Wave.chordDelay = 0.08f;
            preset.Stiffness.elasticity = 0.5f;
        }

        private static void AuthorHind(WingPreset preset)
        {
            Author(preset);
            preset.Size.wingLength = 0.034f;
            preset.Size.wingMass = 3.77e-6f;
            preset.Rest.flap = -5f;
            preset.Rest.sweep = -75f;
            preset.Rest.feather = 88f;
            preset.Rest.tilt = 0f;
        }

        private static void Steady(WingPreset preset) => preset.Beat.frequencyFloor = 1f;

        private static void SteadyAndLate(WingPreset preset)
        {
            Steady(preset);
            preset.Beat.phaseLead = -40f;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.12f;
            preset.Wave.spanDelay = 0.5f;
            preset.Wave.rootShare = 0.55f;
            preset.Stiffness.elasticity = 0.2f;
            preset.Stiffness.springScale = 60f;
            // With 24, one wing in a dozen folds for a moment in 10 m/s.
            preset.SubstepsPerBeat = 36;
        }

        private static void SoftenHind(WingPreset preset)
        {
            Soften(preset);
            preset.Beat.phaseLead = -30f;
        }

        private static void Fly(WingPreset preset)
        {
            FlightVariant.Apply(preset);
            preset.Beat.maxFrequency = 19.5f;
        }

        private static InsectSource[] Sources()
        {
            const string film = "A. Smith, film at 3200 frames/s, North Carolina Museum of Natural Sciences 2020";
            const InsectVariant biological = InsectVariant.Biological;
            const InsectVariant expressive = InsectVariant.Expressive;
            return new[]
            {
                new InsectSource("wing length", "fore 37.6 mm", film),
                new InsectSource("wing length", "hind 34 mm", "assumed: a little shorter and broader than the fore wing"),
                new InsectSource("wing outlines", "11 landmarks each, 3.1 and 3.2 cm²", "proportions chosen by us"),
                new InsectSource(
                    "wing mass", "fore 3.62 mg, hind 3.77 mg", "assumed: ρ* of 18 for the fore wing, 11.8 g/m² of membrane for both"),
                new InsectSource("insect mass", "0.2 g", "assumed: a slender body of 30 mm"),
                new InsectSource("MAX_f", "11 Hz", "the paper, Sec. 5.1 and 7.1"),
                new InsectSource("MAX_f", "11 Hz at any speed", film, biological),
                new InsectSource("phase of the hind wing", "with the fore wing", "assumed: the paper says nothing of it"),
                new InsectSource(
                    "phase of the hind wing", "40° later",
                    "Ennos and Wootton 1989, measured on the scorpion fly Panorpa, whose two pairs of wings are as alike; not "
                    + "measured on fishflies",
                    biological),
                new InsectSource("u_max", "2 m/s", "assumed: as the monarch's"),
                new InsectSource("MAX_a flap, feather, sweep", "120°, 24°, 0°", "the paper, Table 1"),
                new InsectSource("elasticity k_e", "0.5", "the paper, Table 2"),
                new InsectSource("triangles", "1210 on four wings", "the paper, Table 2"),
                new InsectSource("chord delay λ", "0.08", "chosen: a lag of some 12° on a narrow, soft wing"),
                new InsectSource("k_e, λ, μ, w_0, κ", "0.2, 0.12, 0.5, 0.55, 60",
                    "chosen for the eye: wings that flutter like flags, as in the paper's Fig. 13", expressive),
                new InsectSource(
                    "phase of the hind wing", "30° later", "chosen for the eye: the flutter runs on from wing to wing", expressive),
                new InsectSource("MAX_f", "19.5 Hz", "chosen: the beat at which these wings carry 0.2 g; 11 Hz carry a third of it",
                    InsectVariant.Flight),
                new InsectSource("veins, colours", "nine veins, six forks, cross veins", "drawn by us"),
            };
        }
    }
}
