using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class MonarchTests
    {
        private const double k_OnePercent = 0.01;

        [Test]
        public void RestJoint_AndArea_AreThoseOfTheMeasuredOutline()
        {
            WingRig rig = Monarch.GridRig();
            float3 joint = rig.RestJoints[2 * rig.JointsPerChain + 2] + Monarch.Hinge;
            float area = rig.Area;
            rig.Release();
            (double x, double z) = MonarchLandmarks.MiddleJoint();
            double expected = MonarchLandmarks.GridArea(48);
            Assert.That(joint.x, Is.EqualTo(x).Within(x * Lanes.CheckTolerance));
            Assert.That(joint.y, Is.Zero);
            Assert.That(joint.z, Is.EqualTo(z).Within(x * Lanes.CheckTolerance));
            Assert.That(area, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        // The numbers are those of another implementation of the first-order model, written before this one and apart from it.
        [Test]
        public void Monarch_AfterAQuarterBeatAndAfterFiveBeats_IsThatOfTheReferenceImplementation()
        {
            WingRig rig = Monarch.GridRig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.FirstOrder, Monarch.Flying());
                rig.Release();
                float dt = 1f / (24f * world.Read(wing).Frequency);
                Fly(world, dt, 6);
                AssertJoint(world.Read(wing).JointPosition(4, 4), 0.414346, 0.38643, -0.284182);
                Fly(world, dt, 114);
                AssertJoint(world.Read(wing).JointPosition(0, 4), 0.527477, 0.848856, 0.0832966);
                Assert.That(world.Read(wing).SpringEnergy, Is.EqualTo(0.358769).Within(0.358769 * k_OnePercent));
            }
        }

        [Test]
        public void Patches_AreAsGoodAsTriangles_ForTheJoints()
        {
            float3 triangles = TipAfterFiveBeats(0), patches = TipAfterFiveBeats(256);
            Assert.That(math.distance(triangles, patches), Is.LessThan(0.01f));
        }

        private static float3 TipAfterFiveBeats(int patches)
        {
            WingRig rig = Monarch.GridRig(patches);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.FirstOrder, Monarch.Flying());
                rig.Release();
                Fly(world, 1f / (24f * world.Read(wing).Frequency), 120);
                return world.Read(wing).JointPosition(0, 4);
            }
        }

        private static void Fly(WingWorld world, float dt, int steps)
        {
            for (int k = 0; k < steps; k++)
                world.Step(dt);
        }

        private static void AssertJoint(float3 joint, double x, double y, double z)
        {
            joint += Monarch.Hinge;
            Assert.That(joint.x, Is.EqualTo(x).Within(x * k_OnePercent));
            Assert.That(joint.y, Is.EqualTo(y).Within(y * k_OnePercent));
            Assert.That(joint.z, Is.EqualTo(z).Within(System.Math.Abs(z) * k_OnePercent));
        }
    }
}
