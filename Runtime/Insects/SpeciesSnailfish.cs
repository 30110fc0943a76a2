using UnityEngine;

namespace Alate
{
    /// <summary>A snailfish of the kind of Liparis, whose broad pectoral fins beat like wings, in water.</summary>
    static class SpeciesSnailfish
    {
        static readonly double[] s_Span = { 0, 2, 5, 9, 13, 17, 21, 24.5, 27.4, 29.3, 30 };
        static readonly double[] s_Leading = { 2.5, 4.2, 6.6, 9.4, 11.8, 13.4, 13.8, 12.8, 10.2, 6.6, 3.6 };
        static readonly double[] s_Trailing = { -8.0, -15.0, -18.8, -20.2, -19.8, -18.0, -15.2, -11.8, -7.6, -3.4, -0.4 };

        public static SpeciesDefinition Define()
        {
            var fin = new SpeciesWing("fin", WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing), _ => { })
            {
                TriangleCount = 1600,
                LastTipSpan = 0.1,
                Hinge = new Vector3(9e-3f, 1e-3f, 2e-3f),
            };
            return new SpeciesDefinition("snailfish", "Snailfish", new[] { fin }, SnailfishBody.Create(fin), new SpeciesSource[0]);
        }
    }
}
