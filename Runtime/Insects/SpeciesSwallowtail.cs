using UnityEngine;

namespace Alate
{
    /// <summary>A swallowtail of the kind of Papilio. It flies mainly by its fore wings; the tailed hind wings follow with a smaller amplitude.</summary>
    static class SpeciesSwallowtail
    {
        static readonly double[] s_ForeSpan = { 0, 4, 9, 15, 21, 26.5, 30.5, 33.5, 37, 40.5, 43, 44.4, 45 };
        static readonly double[] s_ForeLeading = { 0.8, 3.2, 5.8, 8.6, 11.2, 13.4, 14.8, 15.7, 16.5, 16.9, 16.6, 15.9, 15.0 };
        static readonly double[] s_ForeTrailing = { -1.2, -2.6, -3.9, -5.2, -6.4, -7.2, -7.4, -5.8, -0.6, 5.6, 9.9, 12.2, 13.4 };
        static readonly double[] s_HindSpan = { 0, 1.2, 3, 6, 9.5, 12.5, 15.5, 17.6, 18.8, 19.8, 20.8, 21.8, 22.8, 24.2, 26.5, 29, 31.4, 33.2, 34 };
        static readonly double[] s_HindLeading = { 0.6, 1.4, 2.0, 2.2, 2.0, 1.6, 1.0, 0.5, 0.2, -0.1, -0.4, -0.8, -1.1, -1.7, -2.8, -4.4, -6.4, -8.8, -10.4 };

        static readonly double[] s_HindTrailing =
        {
            -1.8, -7.0, -15.5, -24.5, -30.5, -32.8, -33.0, -34.6, -40.0, -45.4, -47.0, -45.8, -39.0, -32.6, -28.6, -24.2, -19.4, -15.0, -12.2,
        };

        static void AuthorFore(WingSpecies species)
        {
            species.Size.wingLength = 0.045f;
            species.Size.wingMass = 14e-6f;
            species.Size.insectMass = 0.45e-3f;
            species.Beat.flapRange = 116f;
            species.Beat.meanFlap = 12f;
        }

        static void AuthorHind(WingSpecies species)
        {
            AuthorFore(species);
            species.Size.wingLength = 0.034f;
            species.Size.wingMass = 14e-6f;
            species.Beat.flapRange = 92f;
            species.Beat.meanFlap = 0f;
        }

        public static SpeciesDefinition Define()
        {
            var foreOutline = WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing);
            var hindOutline = WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing);
            var fore = new SpeciesWing("fore wing", foreOutline, AuthorFore)
            {
                TriangleCount = 1080,
                ChainPaths = ChainPath.Straight(0.46, 0.52, 0.58, 0.64, 0.71),
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.1e-3f),
                Pattern = new SwallowtailForePattern(foreOutline.Smoothed()),
            };
            var hind = new SpeciesWing("hind wing", hindOutline, AuthorHind)
            {
                TriangleCount = 1320,
                JointsPerChain = 6,
                ChainPaths = new[]
                {
                    new ChainPath(0.28), new ChainPath(0.36), new ChainPath(0.44), new ChainPath(0.5945, (0.597, -0.955)), new ChainPath(0.745),
                    new ChainPath(0.82),
                },
                Hinge = new Vector3(2.1e-3f, 0.9e-3f, -1.4e-3f),
                Pattern = new SwallowtailHindPattern(hindOutline.Smoothed()),
            };
            return new SpeciesDefinition(
                "swallowtail", "Swallowtail", new[] { fore, hind }, SwallowtailBody.Create(fore, hind), new SpeciesSource[0]);
        }
    }
}
