using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Laws of lattices on wings: where their rings end.</summary>
    public sealed class WingLatticeLaws
    {
        // The last row of rings lies behind the edge, by a share of what the air has passed it in a step.
        [TestCase(0f)]
        [TestCase(0.25f)]
        [TestCase(1f)]
        public void TheLastRowOfRings_LiesBehindTheEdge_ByItsShareOfAStep(float share)
        {
            const float k_Step = 0.05f;
            float3 stream = new(0.3f, 0.1f, -4f);
            var settings = new WakeSettings(WakeMethod.Panels) { TrailingShare = share, ChordPanels = 2, SpanPanels = 3 };
            var lattice = new WingLattice(new WakeWing(new ThinWing { Span = 2f, Root = 0f, Move = _ => (0.1, 0.7, 0.1, 0.5) }), settings);
            lattice.Place(0.0, stream, k_Step);
            for (int j = 0; j <= 3; j++)
            {
                int edge = lattice.Corner(2, j);
                float3 path = k_Step * (stream - lattice.CornerVelocities[edge]);
                Assert.That(math.length(path), Is.GreaterThan(0.15f));
                Assert.That(math.distance(lattice.Rings[edge], lattice.Corners[edge] + share * path), Is.LessThan(1e-5f));
            }
        }
    }
}
