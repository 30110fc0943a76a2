using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A firefly of the kind of Photinus pyralis. Its hind wings beat; the elytra, its hardened fore wings, are held open and still, and
    /// belong to the body.
    /// </summary>
    internal static class FireflyDefinition
    {
        private static readonly double[] s_Span = { 0, 0.7, 1.6, 2.8, 4.2, 5.6, 7.0, 8.2, 9.1, 10.0 };
        private static readonly double[] s_Leading = { 0.3, 0.46, 0.62, 0.78, 0.9, 0.95, 0.9, 0.71, 0.5, 0.24 };
        private static readonly double[] s_Trailing = { -0.95, -2.0, -2.75, -3.2, -3.35, -3.25, -2.95, -2.52, -2.2, -1.86 };

        public static InsectDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            WingDefinition wing = new WingDefinition("hind wing", outline, Author)
            {
                TriangleCount = 6284,
                ChainPaths = ChainPath.Straight(0.43, 0.53, 0.62, 0.69, 0.76),
                Hinge = new Vector3(1.25e-3f, 0.75e-3f, -0.5e-3f),
                Pattern = Pattern(outline.Smoothed()),
            }.With(InsectVariant.Biological, Quicken).With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Fly);
            return new InsectDefinition("firefly", "Firefly", new[] { wing }, FireflyBody.Create(wing), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 0, 1.45, 1.1, 2.7, 0.5),
                    BodyEllipsoid.Millimetres(0, -0.3, -5, 1.4, 0.75, 3.7, 0.5),
                },
            };
        }

        private static WingPattern Pattern(WingOutline outline)
        {
            VeinFan veins = new VeinFan(outline, 0.55).Add(0.40, 0.455, 0.53, 0.62, 0.70, 0.80)
                .Fork(2, 0.6, 0.575).Fork(3, 0.55, 0.655).Fork(4, 0.5, 0.745).Cross(1, 0.45).Cross(2, 0.5).Cross(3, 0.42);
            return new MembranePattern(outline, veins)
            {
                Membrane = new Color(0.66f, 0.61f, 0.57f, 0.42f),
                Base = new Color(0.50f, 0.42f, 0.36f, 0.6f),
                Vein = new Color(0.24f, 0.19f, 0.16f, 0.95f),
                VeinHalfWidth = 0.0065,
                CostaHalfWidth = 0.016,
                Sheen = 0.18f,
            };
        }

        private static void Author(WingPreset preset)
        {
            preset.Size.wingLength = 0.010f;
            preset.Size.wingMass = 0.139e-6f;
            preset.Size.insectMass = 35e-6f;
            preset.Rest = new PresetRest { feet = new Vector3(0f, -3.3e-3f, -0.6e-3f), flap = -20f, sweep = -85f, feather = 60f };
            preset.Beat.flapRange = 156f;
            preset.Beat.featherRange = 78f;
            preset.Beat.sweepRange = 0f;
            preset.Wave.chordDelay = 0.095f;
            preset.Stiffness.elasticity = 2f;
            preset.Stiffness.strongestWind = 0.75f;
        }

        private static void Quicken(WingPreset preset)
        {
            preset.Beat.maxFrequency = 62f;
            preset.Wave.chordDelay = 0.09f;
            preset.Beat.frequencyFloor = 1f;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.18f;
            preset.Wave.spanDelay = 0.35f;
            preset.Wave.rootShare = 0.6f;
            preset.Stiffness.elasticity = 0.7f;
            preset.Stiffness.strongestWind = 0.65f;
            preset.Stiffness.springScale = 40f;
            preset.SubstepsPerBeat = 24;
        }

        private static void Fly(WingPreset preset)
        {
            Quicken(preset);
            FlightVariant.Apply(preset);
            preset.Size.insectMass = 17.5e-6f;
            preset.Stiffness.springScale = 28f;
        }

        private static InsectSource[] Sources()
        {
            const InsectVariant biological = InsectVariant.Biological;
            const InsectVariant expressive = InsectVariant.Expressive;
            return new[]
            {
                new InsectSource("wing length", "10 mm", "assumed: for a body of 12 mm; Photinus pyralis is 10 to 14 mm long"),
                new InsectSource("wing outline", "10 landmarks, 34 mm²", "proportions chosen by us"),
                new InsectSource("wing mass", "0.139 mg", "assumed: ρ* of 8.8, 4 g/m² of membrane"),
                new InsectSource("insect mass", "35 mg", "assumed: a soft beetle of this size"),
                new InsectSource("MAX_f", "11 Hz", "the paper, Sec. 5.1, for all insects"),
                new InsectSource("MAX_f", "62 Hz at any speed",
                    "A. Smith, film at 3200 frames/s, North Carolina Museum of Natural Sciences 2020", biological),
                new InsectSource("u_max", "2 m/s", "assumed: as the monarch's"),
                new InsectSource("MAX_a flap, feather, sweep", "156°, 78°, 0°", "the paper, Table 1"),
                new InsectSource("elasticity k_e", "2", "the paper, Table 2"),
                new InsectSource("triangles", "12568 on two wings", "the paper, Table 2; the elytra belong to the body"),
                new InsectSource(
                    "chord delay λ", "0.095", "chosen: with the large feathering of Table 1 more stretches the wing beyond 6 %"),
                new InsectSource("chord delay λ", "0.09", "chosen: as above, at the faster beat", biological),
                new InsectSource("strongest wind", "0.75", "chosen: a firefly's tip bends half again as far in 5 m/s as in still air"),
                new InsectSource("k_e, λ, μ, w_0, κ, strongest wind", "0.7, 0.18, 0.35, 0.6, 40, 0.65",
                    "chosen for the eye: a membrane that flutters like a flag, as in the paper's Fig. 11", expressive),
                new InsectSource("MAX_f", "62 Hz", "as biological", InsectVariant.Flight),
                new InsectSource(
                    "insect mass", "17.5 mg", "chosen: half of the other variants', which these wings do not carry", InsectVariant.Flight),
                new InsectSource(
                    "κ", "28", "chosen: the lift of rotation stretches a softer membrane by more than 6 %", InsectVariant.Flight),
                new InsectSource("veins, colours", "six veins and three forks", "drawn by us"),
            };
        }
    }
}
