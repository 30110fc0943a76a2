using Alate.Flight;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>A snailfish of the kind of Liparis, whose broad pectoral fins beat like wings, in water.</summary>
    internal static class SnailfishDefinition
    {
        /// <summary>Shares of the margin between which the rays end; the sixth ray is the fin's tip.</summary>
        private const double k_FirstTip = 0.2387, k_LastTip = 0.8827;

        private static readonly double[] s_Span = { 0, 2, 5, 9, 13, 17, 21, 24.5, 27.4, 29.3, 30 };
        private static readonly double[] s_Leading = { 2.5, 4.2, 6.6, 9.4, 11.8, 13.4, 13.8, 12.8, 10.2, 6.6, 3.6 };
        private static readonly double[] s_Trailing = { -8.0, -11.8, -15.4, -18.0, -18.8, -17.8, -15.2, -11.8, -7.6, -3.4, -0.4 };

        /// <summary>Depths of the hollows between the rays, wing lengths; the ends of the lower rays stand free.</summary>
        private static readonly double[] s_Hollows = { 0.012, 0.013, 0.014, 0.016, 0.018, 0.021, 0.024, 0.028, 0.033, 0.04, 0.048, 0.056,
            0.06, 0.056 };

        public static InsectDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            WingOutline contour = outline.Smoothed();
            WingDefinition fin = new WingDefinition("fin", outline, Author)
            {
                TriangleCount = 1800,
                Scallops = new RimScallops(k_FirstTip, k_LastTip, s_Hollows),
                ChainPaths = Chains(),
                Hinge = new Vector3(9e-3f, 1e-3f, 2e-3f),
                Pattern = new FinPattern(contour, new VeinFan(contour, 0).Add(RayTips())),
            }.With(InsectVariant.Expressive, Soften).With(InsectVariant.Flight, Swim);
            return new InsectDefinition("snailfish", "Snailfish", new[] { fin }, SnailfishBody.Create(fin), Sources())
            {
                FlightParts = new[]
                {
                    BodyEllipsoid.Millimetres(0, 0, 6, 9.5, 9.2, 19, 0.65),
                    BodyEllipsoid.Millimetres(0, 0.5, -30, 4, 6, 37, 0.35),
                },
            };
        }

        /// <summary>Tips of rays on the margin, each at an end of a hollow.</summary>
        private static double[] RayTips()
        {
            double[] tips = new double[s_Hollows.Length + 1];
            for (int ray = 0; ray < tips.Length; ray++)
                tips[ray] = k_FirstTip + (k_LastTip - k_FirstTip) * ray / s_Hollows.Length;
            return tips;
        }

        /// <summary>A chain along every second ray.</summary>
        private static ChainPath[] Chains()
        {
            double[] tips = RayTips();
            var chains = new ChainPath[tips.Length / 2 + 1];
            for (int chain = 0; chain < chains.Length; chain++)
                chains[chain] = new ChainPath(tips[2 * chain]);
            return chains;
        }

        private static void Author(WingPreset preset)
        {
            preset.Size.wingLength = 0.030f;
            preset.Size.wingMass = 0.2e-3f;
            preset.Size.insectMass = 15e-3f;
            preset.Size.fluidDensity = 998f;
            preset.Size.gravityShare = 0f;
            preset.Rest = new PresetRest { feet = new Vector3(0f, -11e-3f, -30e-3f), flap = 25f, tilt = -20f };
            preset.Beat.maxFrequency = 2.5f;
            preset.Beat.maxSpeed = 0.2f;
            preset.Beat.flapRange = 80f;
            preset.Beat.featherRange = 20f;
            preset.Beat.sweepRange = 20f;
            preset.Beat.meanFlap = 0f;
            preset.Beat.tilt = -20f;
            preset.Stiffness.elasticity = 14f;
            preset.Options.coefficients = CoefficientSet.FlatPlate;
        }

        private static void Soften(WingPreset preset)
        {
            preset.Wave.chordDelay = 0.22f;
            preset.Wave.spanDelay = 0.3f;
            preset.Wave.rootShare = 0.65f;
            preset.Stiffness.elasticity = 7f;
            preset.SubstepsPerBeat = 24;
        }

        private static void Swim(WingPreset preset)
        {
            FlightVariant.Apply(preset);
            // In water the term is large, and of first order in the substep: it moves the fin by 0.8 % of its length between two steps.
            preset.Options.attachedRotation = false;
            preset.Beat.featherRange = 16f;
        }

        private static InsectSource[] Sources()
        {
            return new[]
            {
                new InsectSource("fin length", "30 mm", "assumed: a fish of 100 mm with large pectoral fins"),
                new InsectSource("fin outline", "11 landmarks, 15 rays, 7.3 cm²",
                    "proportions chosen by us: a broad fan whose lower rays stand free of the membrane"),
                new InsectSource("fin mass", "0.2 g", "assumed: 7.3 cm² of jelly-like skin and rays, 0.27 mm thick"),
                new InsectSource("fish mass", "15 g", "assumed; it floats, so that it has no weight"),
                new InsectSource("fluid density", "998 kg/m³", "fresh water at 20 °C"),
                new InsectSource("share of gravity", "0", "assumed: the fin neither sinks nor rises"),
                new InsectSource("coefficients", "FlatPlate", "chosen: a flat fin at large angles of attack"),
                new InsectSource("MAX_f", "2.5 Hz", "assumed: an unhurried beat of pectoral fins"),
                new InsectSource("u_max", "0.2 m/s", "assumed: two body lengths a second"),
                new InsectSource("MAX_a flap, feather, sweep", "80°, 20°, 20°", "assumed: not in Table 1"),
                new InsectSource("tilt of the stroke", "−20°, the downstroke backwards",
                    "Walker and Westneat 1997, measured on the wrasse Gomphosus varius, which flies by its pectoral fins"),
                new InsectSource(
                    "elasticity k_e", "14", "assumed: not in Table 2; water loads a fin some ten times more than air a wing of its mass"),
                new InsectSource("triangles", "3600 on two fins", "chosen: a handful along each hollow of the margin"),
                new InsectSource("chord delay λ", "0.15", "assumed: the monarch's"),
                new InsectSource("k_e, λ, μ, w_0", "7, 0.22, 0.3, 0.65", "chosen for the eye: rays that trail", InsectVariant.Expressive),
                new InsectSource(
                    "MAX_a feather", "16°", "chosen: at the full beat the broad root leaves the skin with 20°", InsectVariant.Flight),
                new InsectSource("body", "ellipsoids of trunk and tail, 65 and 35 % of its mass", "chosen: proportions of the drawn body",
                    InsectVariant.Flight),
                new InsectSource("colours", "pink skin, darker rays and blotches", "drawn by us"),
            };
        }
    }
}
