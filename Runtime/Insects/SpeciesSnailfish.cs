using UnityEngine;

namespace Alate
{
    /// <summary>A snailfish of the kind of Liparis, whose broad pectoral fins beat like wings, in water.</summary>
    static class SpeciesSnailfish
    {
        static readonly double[] s_Span = { 0, 2, 5, 9, 13, 17, 21, 24.5, 27.4, 29.3, 30 };
        static readonly double[] s_Leading = { 2.5, 4.2, 6.6, 9.4, 11.8, 13.4, 13.8, 12.8, 10.2, 6.6, 3.6 };
        static readonly double[] s_Trailing = { -8.0, -15.0, -18.8, -20.2, -19.8, -18.0, -15.2, -11.8, -7.6, -3.4, -0.4 };

        static void Author(WingSpecies species)
        {
            species.Size.wingLength = 0.030f;
            species.Size.wingMass = 2e-4f;
            species.Size.insectMass = 15e-3f;
            species.Size.fluidDensity = 998f;
            species.Size.gravityShare = 0f;
            species.Beat.maxFrequency = 2.5f;
            species.Beat.maxSpeed = 0.3f;
            species.Beat.flapRange = 80f;
            species.Beat.featherRange = 20f;
            species.Beat.sweepRange = 20f;
            species.Beat.meanFlap = 0f;
            species.Beat.tilt = 30f;
            species.Stiffness.elasticity = 12f;
            species.Options.coefficients = CoefficientSet.FlatPlate;
        }

        static double[] RayTips()
        {
            var tips = new double[s_Hollows.Length + 1];
            for (var ray = 0; ray < tips.Length; ray++)
            {
                tips[ray] = 0.2 + 0.72 * ray / s_Hollows.Length;
            }

            return tips;
        }

        static readonly double[] s_Hollows = { 0.012, 0.012, 0.014, 0.016, 0.018, 0.02, 0.022, 0.025, 0.028, 0.032, 0.038, 0.046, 0.054, 0.06, 0.06, 0.05 };

        public static SpeciesDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            var fin = new SpeciesWing("fin", outline, Author)
            {
                TriangleCount = 1800,
                ChainPaths = ChainPath.Straight(0.2, 0.29, 0.38, 0.47, 0.56, 0.65, 0.74, 0.83, 0.92),
                Hinge = new Vector3(9e-3f, 1e-3f, 2e-3f),
                Scallops = new RimScallops(0.2, 0.92, s_Hollows),
                Pattern = new FinPattern(outline.Smoothed(), new VeinFan(outline.Smoothed(), 0).Add(RayTips())),
            };
            return new SpeciesDefinition("snailfish", "Snailfish", new[] { fin }, SnailfishBody.Create(fin), new SpeciesSource[0]);
        }
    }
}
