using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Influences of rings of several wings above a ground, against those of each wing alone.</summary>
    public sealed class RingInfluenceTests
    {
        private const int k_Chord = 2, k_Span = 3, k_Rings = k_Chord * k_Span;

        private static readonly WakeSettings s_Settings = new(WakeMethod.Panels) { ChordPanels = k_Chord, SpanPanels = k_Span };

        [Test]
        public void TheOwnPart_IsThatOfTheWingAlone_AndImagesAndOtherWingsAddTheRest()
        {
            WingLattice[] lattices = [Lattice(0f), Lattice(2.5f)];
            var images = new MirrorImages(false, true, new float3(0f, 1f, 0f), 0.8f);
            using RingInfluences all = Influences(images, lattices);
            for (int wing = 0; wing < 2; wing++)
            {
                using RingInfluences alone = Influences(new MirrorImages(false, false, default, 0f), lattices[wing]);
                for (int ring = 0; ring < k_Rings; ring++)
                {
                    for (int source = 0; source < 2 * k_Rings; source++)
                    {
                        float3 whole = all.Velocity(wing, ring, source, out float3 own);
                        bool isOwn = source / k_Rings == wing;
                        float3 expected = isOwn ? alone.Velocity(0, ring, source % k_Rings, out _) : default;
                        Assert.That(math.distance(own, expected), Is.LessThan(1e-6f), $"{wing} {ring} {source}");
                        Assert.That(math.distance(whole, own), Is.GreaterThan(1e-4f), "the image adds to it");
                    }
                }
            }
        }

        private static WingLattice Lattice(float root)
        {
            var plate = new ThinWing { Span = 2f, Root = root, Move = _ => (0.0, 0.0, 0.1, 0.0) };
            var lattice = new WingLattice(new WakeWing(plate), s_Settings);
            lattice.Place(0.0, s_Settings.Stream, 0.05f);
            return lattice;
        }

        private static RingInfluences Influences(MirrorImages images, params WingLattice[] lattices)
        {
            int[] first = new int[lattices.Length + 1];
            for (int wing = 0; wing < lattices.Length; wing++)
                first[wing + 1] = first[wing] + k_Rings;
            var influences = new RingInfluences(first, images);
            for (int wing = 0; wing < lattices.Length; wing++)
            {
                influences.SetRings(wing, lattices[wing], new WakeCores(s_Settings, lattices[wing].MeanChord), true);
                for (int ring = 0; ring < k_Rings; ring++)
                    influences.SetPoint(wing, ring, lattices[wing].Controls[ring]);
            }

            influences.Evaluate();
            return influences;
        }
    }
}
