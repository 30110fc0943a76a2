using UnityEngine;

namespace Alate
{
    /// <summary>
    /// A firefly of the kind of Photinus pyralis. Its hind wings beat; the elytra, its hardened fore wings, are held open and still, and belong to the body.
    /// </summary>
    static class SpeciesFirefly
    {
        static readonly double[] s_Span = { 0, 0.7, 1.6, 2.8, 4.2, 5.6, 7.0, 8.2, 9.2, 9.8, 10.0 };
        static readonly double[] s_Leading = { 0.3, 0.46, 0.62, 0.78, 0.9, 0.95, 0.9, 0.68, 0.24, -0.28, -0.62 };
        static readonly double[] s_Trailing = { -0.95, -2.0, -2.75, -3.2, -3.35, -3.25, -2.95, -2.5, -1.95, -1.4, -1.08 };

        static WingPattern Pattern(WingOutline outline)
        {
            var veins = new VeinFan(outline, 0.55).Add(0.40, 0.455, 0.53, 0.62, 0.70, 0.80)
                .Fork(2, 0.6, 0.575).Fork(3, 0.55, 0.655).Fork(4, 0.5, 0.745).Cross(1, 0.45).Cross(2, 0.5).Cross(3, 0.42);
            return new MembranePattern(outline, veins)
            {
                Membrane = new Color(0.66f, 0.61f, 0.57f, 0.42f),
                Base = new Color(0.50f, 0.42f, 0.36f, 0.6f),
                Vein = new Color(0.24f, 0.19f, 0.16f, 0.95f),
                VeinHalfWidth = 0.008,
                CostaHalfWidth = 0.018,
            };
        }

        static void Author(WingSpecies species)
        {
            species.Size.wingLength = 0.010f;
            species.Size.wingMass = 1.39e-7f;
            species.Size.insectMass = 35e-6f;
            species.Beat.flapRange = 156f;
            species.Beat.featherRange = 78f;
            species.Beat.sweepRange = 0f;
            species.Wave.chordDelay = 0.1f;
            species.Stiffness.elasticity = 2f;
        }

        public static SpeciesDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            var wing = new SpeciesWing("hind wing", outline, Author)
            {
                TriangleCount = 6284,
                ChainPaths = ChainPath.Straight(0.43, 0.53, 0.65, 0.688, 0.759),
                Hinge = new Vector3(1.25e-3f, 0.75e-3f, -0.5e-3f),
                Pattern = Pattern(outline.Smoothed()),
            };
            return new SpeciesDefinition("firefly", "Firefly", new[] { wing }, FireflyBody.Create(wing), new SpeciesSource[0]);
        }
    }
}
