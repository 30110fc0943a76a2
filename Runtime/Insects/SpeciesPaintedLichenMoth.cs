using UnityEngine;

namespace Alate
{
    /// <summary>The painted lichen moth, Hypoprepia fucosa. Its fore and hind wing are hooked to each other and are one wing here, as the monarch's are.</summary>
    static class SpeciesPaintedLichenMoth
    {
        static readonly double[] s_Span = { 0, 0.9, 2.0, 3.6, 5.2, 6.8, 8.2, 9.4, 10.3, 11.0, 12.0, 12.9, 13.6, 14.0 };
        static readonly double[] s_Leading = { 0.25, 0.7, 1.25, 1.95, 2.55, 3.05, 3.4, 3.6, 3.7, 3.75, 3.65, 3.25, 2.55, 1.7 };
        static readonly double[] s_Trailing = { -0.6, -2.9, -5.1, -7.1, -7.9, -7.9, -7.3, -6.1, -4.4, -2.6, -1.7, -0.9, 0.1, 0.9 };

        static void Author(WingSpecies species)
        {
            species.Size.wingLength = 0.014f;
            species.Size.wingMass = 8.4e-7f;
            species.Size.insectMass = 25e-6f;
            species.Beat.flapRange = 126f;
            species.Beat.featherRange = 37f;
            species.Beat.sweepRange = 37f;
            species.Stiffness.elasticity = 1.8f;
        }

        public static SpeciesDefinition Define()
        {
            var outline = WingOutline.FromMillimetres(s_Span, s_Leading, s_Trailing);
            var wing = new SpeciesWing("wing", outline, Author)
            {
                TriangleCount = 824,
                ChainPaths = ChainPath.Straight(0.39, 0.425, 0.503, 0.594, 0.78),
                Hinge = new Vector3(1.15e-3f, 0.6e-3f, 0.7e-3f),
                Pattern = new LichenMothPattern(outline.Smoothed()),
            };
            return new SpeciesDefinition(
                "painted-lichen-moth", "Painted lichen moth", new[] { wing }, PaintedLichenMothBody.Create(wing), new SpeciesSource[0]);
        }
    }
}
