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
            var fore = new SpeciesWing("fore wing", WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing), Author)
            {
                TriangleCount = 280,
                ChainPaths = ChainPath.Straight(0.46, 0.516, 0.592, 0.703, 0.789),
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.8e-3f),
            };
            var hind = new SpeciesWing("hind wing", WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing), AuthorHind)
            {
                TriangleCount = 325,
                ChainPaths = ChainPath.Straight(0.44, 0.51, 0.59, 0.68, 0.79),
                Hinge = new Vector3(2.1e-3f, 1.2e-3f, -2.2e-3f),
            };
            return new SpeciesDefinition("fishfly", "Fishfly", new[] { fore, hind }, FishflyBody.Create(fore, hind), new SpeciesSource[0]);
        }
    }
}
