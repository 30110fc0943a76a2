using UnityEngine;

namespace Alate
{
    /// <summary>The painted lichen moth, Hypoprepia fucosa. Its fore and hind wing are hooked to each other and are one wing here, as the monarch's are.</summary>
    static class SpeciesPaintedLichenMoth
    {
        static readonly double[] s_Span = { 0, 0.9, 2.0, 3.6, 5.2, 6.8, 8.1, 9.0, 9.7, 10.6, 11.8, 12.9, 13.6, 14.0 };
        static readonly double[] s_Leading = { 0.25, 0.7, 1.25, 1.95, 2.5, 2.95, 3.25, 3.4, 3.5, 3.55, 3.45, 3.05, 2.4, 1.6 };
        static readonly double[] s_Trailing = { -0.6, -2.9, -5.0, -6.9, -7.6, -7.4, -6.5, -5.1, -3.2, -2.2, -1.6, -0.8, 0.1, 0.9 };

        public static SpeciesDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            var wing = new SpeciesWing("wing", outline, _ => { })
            {
                TriangleCount = 824,
                LastTipSpan = 0.36,
                Hinge = new Vector3(1.15e-3f, 0.6e-3f, 0.7e-3f),
            };
            return new SpeciesDefinition(
                "painted-lichen-moth", "Painted lichen moth", new[] { wing }, PaintedLichenMothBody.Create(wing), new SpeciesSource[0]);
        }
    }
}
