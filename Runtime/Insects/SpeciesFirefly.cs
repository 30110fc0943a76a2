using UnityEngine;

namespace Alate
{
    /// <summary>
    /// A firefly of the kind of Photinus pyralis. Its hind wings beat; the elytra, its hardened fore wings, are held open and still, and belong to the body.
    /// </summary>
    static class SpeciesFirefly
    {
        static readonly double[] s_Span = { 0, 0.7, 1.6, 2.8, 4.2, 5.6, 7.0, 8.2, 9.2, 9.8, 10.0 };
        static readonly double[] s_Leading = { 0.25, 0.42, 0.58, 0.74, 0.86, 0.92, 0.88, 0.68, 0.28, -0.22, -0.55 };
        static readonly double[] s_Trailing = { -0.65, -1.55, -2.3, -2.85, -3.05, -3.0, -2.8, -2.45, -1.95, -1.4, -1.05 };

        public static SpeciesDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            var wing = new SpeciesWing("hind wing", outline, _ => { })
            {
                TriangleCount = 6284,
                LastTipSpan = 0.3,
                Hinge = new Vector3(1.25e-3f, 0.75e-3f, -0.5e-3f),
            };
            return new SpeciesDefinition("firefly", "Firefly", new[] { wing }, FireflyBody.Create(wing), new SpeciesSource[0]);
        }
    }
}
