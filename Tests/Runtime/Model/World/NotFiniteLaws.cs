using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// Numbers that are none, or beyond reason: which wing of a pack has one, what it costs the others, and bounds that meet them.
    /// </summary>
    public sealed unsafe class NotFiniteLaws
    {
        private delegate void Edit(ref WingPack pack, int lane, float value);

        private static readonly (string name, Edit edit)[] s_Places =
        {
            ("position, first joint", (ref WingPack pack, int lane, float value) => pack.pose[0].position.x[lane] = value),
            ("position, last joint",
                (ref WingPack pack, int lane, float value) => pack.pose[pack.rig.jointCount - 1].position.z[lane] = value),
            ("rotation", (ref WingPack pack, int lane, float value) => pack.pose[1].rotation.w[lane] = value),
            ("deviation", (ref WingPack pack, int lane, float value) => pack.offsetRates[pack.rig.jointCount - 1].y[lane] = value),
            ("bend, first bone", (ref WingPack pack, int lane, float value) => pack.bendRates[0].y[lane] = value),
            ("bend, last bone", (ref WingPack pack, int lane, float value) => pack.bendRates[pack.rig.boneCount - 1].x[lane] = value),
        };

        [Test]
        public void AWingWithOne_IsFound_AndNoOtherOfItsPack(
            [Values(float.NaN, float.PositiveInfinity, float.NegativeInfinity)] float value, [Values(0, 3)] int lane)
        {
            foreach ((string name, Edit edit) in s_Places)
            {
                using (var fixture = new PackFixture(Monarch.Rig(64), Monarch.Parameters))
                {
                    Assert.That(math.any(PackReset.NotFinite(fixture.Pack)), Is.False, name);
                    edit(ref fixture.Pack, lane, value);
                    bool4 found = PackReset.NotFinite(fixture.Pack);
                    for (int other = 0; other < WingPack.Lanes; other++)
                        Assert.That(found[other], Is.EqualTo(other == lane), $"{name}, lane {other}");
                }
            }
        }

        [Test]
        public void EveryComponent_IsLookedAt()
        {
            using (var fixture = new PackFixture(TestWings.Rig(8), WingParameters.Default))
            {
                ref WingPack pack = ref fixture.Pack;
                for (int lane = 0; lane < WingPack.Lanes; lane++)
                {
                    for (int axis = 0; axis < 3; axis++)
                    {
                        float3 bad = 0f;
                        bad[axis] = float.NaN;
                        AssertFound(ref pack.pose[lane].position, pack, lane, bad);
                        AssertFound(ref pack.offsetRates[lane + 1], pack, lane, bad);
                        AssertFound(ref pack.bendRates[lane], pack, lane, bad);
                    }
                }
            }
        }

        [Test]
        public void SurroundingsBeyondReason_HarmAWing_OnlyWhileTheyLast([Values(0, 1, 2, 3, 4, 5)] int field)
        {
            float[] values = { 1e6f, 1e38f, -1e38f };
            using (var twin = new FlownMonarch())
            {
                WingRig rig = Monarch.Rig();
                WingSurroundings usual = Monarch.Flying(1.3f, 0f);
                WingHandle[] wings = values.Select(_ => twin.world.Add(rig, Monarch.Parameters, usual)).ToArray();
                rig.Release();
                for (int step = 0; step < 105; step++)
                {
                    for (int k = 0; k < wings.Length; k++)
                        twin.world.SetSurroundings(wings[k], step < 5 ? Storm(usual, field, values[k]) : usual);
                    twin.world.Step(0.02f);
                    foreach (WingHandle wing in wings.Append(twin.wing))
                        Assert.That(math.all(math.isfinite(twin.world.Read(wing).JointPosition(4, 4))), $"step {step}");
                }

                Assert.That(twin.Reading.Resets, Is.Zero);
                foreach (WingHandle wing in wings)
                {
                    Assert.That(twin.world.Read(wing).Frequency, Is.EqualTo(twin.Reading.Frequency).Within(1e-3f));
                    Assert.That(math.isfinite(twin.world.Read(wing).Phase));
                }

                int[] resets = wings.Select(wing => twin.world.Read(wing).Resets).ToArray();
                twin.world.Step(0.5f);
                Assert.That(wings.Select(wing => twin.world.Read(wing).Resets), Is.EqualTo(resets));
            }
        }

        private static WingSurroundings Storm(WingSurroundings air, int field, float value)
        {
            switch (field)
            {
                case 0: air.wind.y = value; break;
                case 1: air.gravity.y = value; break;
                case 2: air.angularVelocity.x = value; break;
                case 3: air.hinge.x = value; break;
                case 4: air.speed = value; break;
                default: air.angleOfAttack = value; break;
            }

            return air;
        }

        [Test]
        public void ARestartedWing_HasNone_AndIsCountedOnce()
        {
            using (var fixture = new PackFixture(Monarch.Rig(64), Monarch.Parameters))
            {
                float4 before = fixture.Pack.readings->resets;
                fixture.Pack.pose[2].position.y[1] = float.NaN;
                bool4 found = PackReset.NotFinite(fixture.Pack);
                PackReset.Recover(fixture.Pack, fixture.scratch, found);
                Assert.That(math.any(PackReset.NotFinite(fixture.Pack)), Is.False);
                float4 more = fixture.Pack.readings->resets - before;
                Assert.That(math.all(more == new float4(0f, 1f, 0f, 0f)), Is.True, more.ToString());
            }
        }

        [Test]
        public void Bounds_HoldAllPoints_AndLeaveOutWhatIsNoPlace()
        {
            SoaBounds bounds = SoaBounds.Empty;
            bounds.Encapsulate(new SoaFloat3(new float3(1f, -2f, 3f)));
            bounds.Encapsulate(new SoaFloat3(new float3(-4f, 5f, float.NaN)));
            bounds.Encapsulate(new SoaFloat3(new float3(float.NaN, 0f, -6f)));
            for (int lane = 0; lane < 4; lane++)
            {
                Assert.That(new float3(bounds.min.x[lane], bounds.min.y[lane], bounds.min.z[lane]), Is.EqualTo(new float3(-4f, -2f, -6f)));
                Assert.That(new float3(bounds.max.x[lane], bounds.max.y[lane], bounds.max.z[lane]), Is.EqualTo(new float3(1f, 5f, 3f)));
            }
        }

        private static void AssertFound(ref SoaFloat3 place, in WingPack pack, int lane, float3 bad)
        {
            SoaFloat3 kept = place, changed = place;
            changed[lane] = bad;
            place = changed;
            bool4 wanted = false;
            wanted[lane] = true;
            Assert.That(PackReset.NotFinite(pack), Is.EqualTo(wanted), $"{bad}");
            place = kept;
        }
    }
}
