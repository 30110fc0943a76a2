using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Transforms that take joints and what moves with them from rest to a pose, in mesh space.</summary>
    public sealed unsafe class SkinPaletteLaws
    {
        [Test]
        public void APointBesideAJoint_MovesWithIt_AtAnyTimeOfAStep_OnBothSides([Values(false, true)] bool mirrored)
        {
            using (var fixture = new PackFixture(TestWings.Rig(16), WingParameters.Default))
            {
                ref WingPack pack = ref fixture.Pack;
                int joints = pack.rig.jointCount;
                var random = new Random(mirrored ? 71u : 70u);
                DualQuaternion* palette = stackalloc DualQuaternion[joints + 1];
                for (int draw = 0; draw < 100; draw++)
                {
                    Draw(ref pack, ref random);
                    WingFrame frame = Frame(ref random, mirrored);
                    var target = new SkinTarget { rig = pack.rig, frame = frame, lane = draw % WingPack.Lanes };
                    float alpha = draw == 0 ? 1f : random.NextFloat();
                    palette[joints] = new DualQuaternion { real = draw };
                    SkinPalette.Evaluate(pack, target, alpha, palette);
                    Assert.That(palette[joints].real.x, Is.EqualTo((float)draw), "nothing is written beyond the last joint");
                    float3 beside = random.NextFloat3(-0.5f, 0.5f);
                    for (int joint = 0; joint < joints; joint++)
                    {
                        float3 rest = pack.rig.restJoints[joint];
                        Pose(pack, target.lane, joint, alpha, out quaternion rotation, out float3 position);
                        float3 expected = frame.ToMesh(position + math.rotate(rotation, beside));
                        float3 moved = palette[joint].Move(frame.ToMesh(rest + beside));
                        Assert.That(math.distance(moved, expected), Is.LessThan(3e-6f * (1f + math.length(expected))), $"joint {joint}");
                        Assert.That(math.length(palette[joint].real), Is.EqualTo(1f).Within(1e-6f));
                    }
                }
            }
        }

        // Two substeps, each kept.
        private static void Draw(ref WingPack pack, ref Random random)
        {
            int joints = pack.rig.jointCount;
            pack.substeps = 2f;
            pack.slotStride = 1f;
            for (int place = 0; place < 3 * joints; place++)
            {
                for (int lane = 0; lane < WingPack.Lanes; lane++)
                {
                    // Within a quarter turn of the slot before, but of either sign.
                    quaternion turn = place < joints ? random.NextQuaternionRotation()
                        : math.mul(Rotation(pack, place - joints, lane),
                            quaternion.AxisAngle(random.NextFloat3Direction(), random.NextFloat(1.5f)));
                    float4 q = random.NextBool() ? turn.value : -turn.value;
                    pack.slots[place].rotation.v.x[lane] = q.x;
                    pack.slots[place].rotation.v.y[lane] = q.y;
                    pack.slots[place].rotation.v.z[lane] = q.z;
                    pack.slots[place].rotation.w[lane] = q.w;
                    pack.slots[place].position[lane] = random.NextFloat3(-1f, 1f);
                }
            }
        }

        private static WingFrame Frame(ref Random random, bool mirrored)
        {
            var axes = new float3x3(random.NextQuaternionRotation());
            if (mirrored)
                axes.c0 = -axes.c0;
            return new WingFrame(random.NextFloat3(-2f, 2f), axes, random.NextFloat(0.3f, 3f), mirrored);
        }

        // By Unity's own algebra, one joint at a time.
        private static void Pose(in WingPack pack, int lane, int joint, float alpha, out quaternion rotation, out float3 position)
        {
            float time = 2f * alpha;
            int slot = math.min((int)time, 1), before = slot * pack.rig.jointCount + joint, after = before + pack.rig.jointCount;
            rotation = math.nlerp(Rotation(pack, before, lane), Rotation(pack, after, lane), time - slot);
            position = math.lerp(pack.slots[before].position[lane], pack.slots[after].position[lane], time - slot);
        }

        private static quaternion Rotation(in WingPack pack, int place, int lane) => pack.slots[place].rotation[lane];
    }
}
