using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Frames of joints: along their bones, turned with the chains beside them, but no farther than that makes sense.</summary>
    public sealed unsafe class JointFramesLaws
    {
        // The wing is turned about its straight leading chain, of which the bones do not move: they turn with the chain beside them.
        [TestCase(0f, 0f)]
        [TestCase(25f, 25f)]
        [TestCase(-40f, -40f)]
        [TestCase(59f, 59f)]
        [TestCase(63f, 60f)]
        [TestCase(-80f, -60f)]
        [TestCase(130f, 60f)]
        public void ABone_RollsWithTheChainBesideIt_BySixtyDegreesAtMost(float degrees, float rolled)
        {
            using (var fixture = new PackFixture(TestWings.Rig(8), WingParameters.Default))
            {
                WingPack pack = fixture.Pack;
                float3 axis = pack.rig.boneDirections[0];
                quaternion turn = quaternion.AxisAngle(axis, Mathf.Deg2Rad * degrees),
                    roll = quaternion.AxisAngle(axis, Mathf.Deg2Rad * rolled);
                for (int bone = 0; bone < pack.rig.boneCount; bone++)
                    pack.bentRotations[bone] = new SoaQuaternion(Lanes.All(0f, 0f, 0f), 1f);
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                    fixture.scratch.positions[joint] = new SoaFloat3(math.rotate(turn, pack.rig.restJoints[joint]));
                JointFrames.Evaluate(pack, fixture.scratch, fixture.scratch.pose);
                for (int joint = 0; joint < pack.rig.jointsPerChain; joint++)
                {
                    float4 found = fixture.scratch.pose[joint].rotation[2].value;
                    Assert.That(math.abs(math.dot(found, roll.value)), Is.EqualTo(1f).Within(1e-5f), $"joint {joint}: {found}");
                    Assert.That(fixture.scratch.pose[joint].position[1], Is.EqualTo(fixture.scratch.positions[joint][1]));
                }
            }
        }

        [Test]
        public void AWingThatTurnsAsAWhole_TurnsAllItsFrames()
        {
            using (var fixture = new PackFixture(TestWings.Rig(8), WingParameters.Default))
            {
                WingPack pack = fixture.Pack;
                var turn = quaternion.AxisAngle(math.normalize(new float3(0.2f, 0.9f, -0.4f)), 1.1f);
                for (int bone = 0; bone < pack.rig.boneCount; bone++)
                    pack.bentRotations[bone] = new SoaQuaternion(new SoaFloat3(turn.value.xyz), turn.value.w);
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                    fixture.scratch.positions[joint] = new SoaFloat3(math.rotate(turn, pack.rig.restJoints[joint]));
                JointFrames.Evaluate(pack, fixture.scratch, fixture.scratch.pose);
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                {
                    float4 found = fixture.scratch.pose[joint].rotation[0].value;
                    Assert.That(math.abs(math.dot(found, turn.value)), Is.EqualTo(1f).Within(1e-5f), $"joint {joint}: {found}");
                }
            }
        }

        // Scratch is the worker's: it holds what another pack left there.
        [TestCase(WingDetail.Full)]
        [TestCase(WingDetail.WavesOnly)]
        public void MotionsOfFrames_TakeNothingFromAnotherPack(WingDetail detail)
        {
            using (var fixture = new PackFixture(TestWings.Rig(8), WingParameters.Default))
            {
                WingPack pack = fixture.Pack;
                pack.detail = detail;
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                    fixture.scratch.deformations[joint] = new SoaQuaternion(new SoaFloat3(new float3(float.NaN)), float.NaN);
                pack.substeps = 1f;
                pack.substepLength = 1e-3f;
                PackStep.Substep(ref pack, fixture.scratch, 1);
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                    Assert.That(math.all(math.isfinite(pack.motions[joint].turning.w)), $"joint {joint}");
            }
        }
    }
}
