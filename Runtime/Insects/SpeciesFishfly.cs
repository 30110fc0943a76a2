using UnityEngine;

namespace Alate
{
    /// <summary>A fishfly of the kind of Chauliodes: four long wings that beat side by side, the hind ones a little later.</summary>
    static class SpeciesFishfly
    {
        static readonly double[] s_ForeSpan = { 0, 2.5, 6, 12, 18, 24, 29, 33, 35.6, 37.0, 37.6 };
        static readonly double[] s_ForeLeading = { 0.6, 1.5, 2.4, 3.7, 4.9, 6.0, 6.6, 6.4, 5.5, 4.2, 3.1 };
        static readonly double[] s_ForeTrailing = { -1.5, -2.6, -3.5, -4.4, -4.9, -4.8, -4.1, -2.7, -1.1, 0.3, 1.4 };
        static readonly double[] s_HindSpan = { 0, 1.6, 4, 8, 13, 18, 23, 28, 31.4, 33.2, 34 };
        static readonly double[] s_HindLeading = { 0.5, 0.6, 0.5, 0.1, -0.4, -1.0, -1.8, -3.0, -4.4, -5.8, -6.8 };
        static readonly double[] s_HindTrailing = { -1.8, -5.6, -9.2, -11.6, -12.4, -12.4, -12.0, -11.0, -9.6, -8.2, -7.2 };

        static WingPattern Pattern(WingOutline outline)
        {
            var veins = new VeinFan(outline, 0.6).Add(0.40, 0.45, 0.48, 0.515, 0.56, 0.61, 0.67, 0.74, 0.82)
                .Fork(2, 0.7, 0.497).Fork(3, 0.62, 0.538).Fork(4, 0.6, 0.585).Fork(5, 0.6, 0.64).Fork(6, 0.6, 0.705).Fork(7, 0.55, 0.78);
            for (var vein = 0; vein < 8; vein++)
            {
                var shift = 0.03 * (vein % 3);
                veins.Cross(vein, 0.3 + shift, 0.44 + shift, 0.57 + shift, 0.7 + shift, 0.82 + shift);
            }

            return new MembranePattern(outline, veins)
            {
                Membrane = new Color(0.80f, 0.77f, 0.70f, 0.45f),
                Base = new Color(0.66f, 0.60f, 0.50f, 0.6f),
                Vein = new Color(0.33f, 0.26f, 0.20f, 0.95f),
                VeinHalfWidth = 0.0045,
                CostaHalfWidth = 0.010,
                Dapple = 0.6f,
            };
        }

        static void Author(WingSpecies species)
        {
            species.Size.wingLength = 0.0376f;
            species.Size.wingMass = 3.62e-6f;
            species.Size.insectMass = 0.2e-3f;
            species.Beat.flapRange = 120f;
            species.Beat.featherRange = 24f;
            species.Beat.sweepRange = 0f;
            species.Wave.chordDelay = 0.08f;
            species.Stiffness.elasticity = 0.5f;
        }

        static void AuthorHind(WingSpecies species)
        {
            Author(species);
            species.Size.wingLength = 0.034f;
            species.Size.wingMass = 3.6e-6f;
        }

        public static SpeciesDefinition Define()
        {
            var foreOutline = WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing);
            var hindOutline = WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing);
            var fore = new SpeciesWing("fore wing", foreOutline, Author)
            {
                TriangleCount = 280,
                ChainPaths = ChainPath.Straight(0.46, 0.516, 0.592, 0.703, 0.789),
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.8e-3f),
                Pattern = Pattern(foreOutline.Smoothed()),
            };
            var hind = new SpeciesWing("hind wing", hindOutline, AuthorHind)
            {
                TriangleCount = 325,
                ChainPaths = ChainPath.Straight(0.44, 0.51, 0.59, 0.68, 0.79),
                Hinge = new Vector3(2.1e-3f, 1.2e-3f, -2.2e-3f),
                Pattern = Pattern(hindOutline.Smoothed()),
            };
            return new SpeciesDefinition("fishfly", "Fishfly", new[] { fore, hind }, FishflyBody.Create(fore, hind), new SpeciesSource[0]);
        }
    }
}
