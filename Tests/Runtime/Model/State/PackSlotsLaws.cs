using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Poses that are kept within a step, so that any time of it can be drawn.</summary>
    public sealed unsafe class PackSlotsLaws
    {
        private static readonly float4[] s_Counts =
        {
            new float4(5f, 12f, 13f, 30f), 1f, 7f, 12f, 13f, 40f, new float4(192f, 1f, 24f, 25f),
        };

        [Test]
        public void AnyTimeOfAStep_LiesBetweenTwoKeptPoses([ValueSource(nameof(s_Counts))] float4 counts)
        {
            using (var fixture = new PackFixture(TestWings.Rig(16), WingParameters.Default))
            {
                ref WingPack pack = ref fixture.Pack;
                int joints = pack.rig.jointCount;
                pack.substeps = counts;
                Mark(pack, 0, counts);
                PackSlots.Begin(ref pack);
                for (int k = 1; k <= (int)math.cmax(counts); k++)
                {
                    Mark(pack, k, counts);
                    PackSlots.Keep(pack, k);
                }

                for (int lane = 0; lane < WingPack.Lanes; lane++)
                {
                    for (float alpha = -0.25f; alpha <= 1.25f; alpha += 0.03125f)
                    {
                        Assert.That(PackSlots.Span(pack, lane, alpha, out int slot, out float blend), Is.True);
                        Assert.That(slot, Is.InRange(0, WingPack.PoseSlots - 2));
                        Assert.That(blend, Is.InRange(0f, 1f));
                        foreach (int joint in new[] { 0, joints - 1 })
                        {
                            float3 before = pack.slots[slot * joints + joint].position[lane],
                                after = pack.slots[(slot + 1) * joints + joint].position[lane];
                            Assert.That(math.lerp(before, after, blend).y - 100f * joint,
                                Is.EqualTo(math.saturate(alpha) * counts[lane]).Within(2e-3f), $"lane {lane}, {alpha} of the step");
                            Assert.That(pack.slots[slot * joints + joint].rotation.w[lane] + 100f * joint,
                                Is.EqualTo(before.y).Within(1e-3f), "with its rotation");
                        }
                    }
                }
            }
        }

        [Test]
        public void BeforeTheFirstStep_ThereIsNone()
        {
            using (var fixture = new PackFixture(TestWings.Rig(16), WingParameters.Default))
            {
                Assert.That(PackSlots.Span(fixture.Pack, 1, 0.5f, out int slot, out float blend), Is.False);
                Assert.That((slot, blend), Is.EqualTo((0, 0f)));
            }
        }

        // The number of the substep, and of the joint; a wing that waits for the others stays.
        private static void Mark(in WingPack pack, int substep, float4 counts)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                pack.pose[joint].position.y = math.min(substep, counts) + 100f * joint;
                pack.pose[joint].rotation.w = math.min(substep, counts);
            }
        }
    }
}
