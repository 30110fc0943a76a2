using UnityEngine;

namespace Alate
{
    /// <summary>A fishfly of the kind of Chauliodes: four long wings that beat side by side, the hind ones a little later.</summary>
    static class SpeciesFishfly
    {
        static readonly double[] s_ForeSpan = { 0, 2.5, 6, 12, 18, 24, 29, 33, 35.6, 37.0, 37.6 };
        static readonly double[] s_ForeLeading = { 0.6, 1.6, 2.7, 4.4, 5.9, 7.2, 7.9, 7.6, 6.4, 4.9, 3.9 };
        static readonly double[] s_ForeTrailing = { -1.5, -2.3, -3.0, -3.7, -3.9, -3.6, -2.8, -1.4, 0.3, 1.6, 2.6 };
        static readonly double[] s_HindSpan = { 0, 1.6, 4, 8, 13, 18, 23, 28, 31.4, 33.2, 34 };
        static readonly double[] s_HindLeading = { 0.5, 0.8, 0.8, 0.6, 0.3, -0.2, -0.9, -2.0, -3.4, -4.9, -6.0 };
        static readonly double[] s_HindTrailing = { -1.8, -5.6, -9.2, -11.6, -12.4, -12.4, -12.0, -11.0, -9.6, -8.2, -7.2 };

        public static SpeciesDefinition Define()
        {
            var fore = new SpeciesWing("fore wing", WingOutline.FromMillimetres(s_ForeSpan, s_ForeLeading, s_ForeTrailing), _ => { })
            {
                TriangleCount = 280,
                LastTipSpan = 0.3,
                Hinge = new Vector3(2.1e-3f, 1.3e-3f, 2.8e-3f),
            };
            var hind = new SpeciesWing("hind wing", WingOutline.FromMillimetres(s_HindSpan, s_HindLeading, s_HindTrailing), _ => { })
            {
                TriangleCount = 325,
                LastTipSpan = 0.3,
                Hinge = new Vector3(2.1e-3f, 1.2e-3f, -2.2e-3f),
            };
            return new SpeciesDefinition("fishfly", "Fishfly", new[] { fore, hind }, FishflyBody.Create(fore, hind), new SpeciesSource[0]);
        }
    }
}
