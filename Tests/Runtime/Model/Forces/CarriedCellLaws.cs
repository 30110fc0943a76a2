using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>
    /// Laws of the surface that frames of joints carry: its normals, its velocity, and what it takes from a body's motion.
    /// </summary>
    public sealed unsafe class CarriedCellLaws
    {
        private const int k_Lane = 2;

        private static readonly float3 s_Hinge = new float3(0.1f, -0.05f, 0.2f), s_Spin = new float3(2f, -3f, 5f);

        private PackFixture m_Pack;

        [SetUp]
        public void MakePack()
        {
            m_Pack = new PackFixture(TestWings.Rig(16), Monarch.Parameters,
                new WingSurroundings { hinge = s_Hinge, angularVelocity = s_Spin });
            var random = Random.CreateFromIndex(7);
            for (int joint = 0; joint < m_Pack.rig.JointCount; joint++)
            {
                m_Pack.scratch.carriedFrames[joint] = new SoaFloat3x3(Rotation(random.NextQuaternionRotation()));
                m_Pack.scratch.carriedSpans[joint] = m_Pack.scratch.carriedFrames[joint].c0;
                m_Pack.scratch.carriedPositions[joint] = new SoaFloat3(random.NextFloat3(-1f, 1f));
                m_Pack.scratch.carriedTurning[joint] = new SoaFloat3(random.NextFloat3(-4f, 4f));
                m_Pack.scratch.drivenVelocities[joint] = new SoaFloat3(random.NextFloat3(-2f, 2f));
                m_Pack.Pack.drivenLags[joint] = new SoaFloat3(random.NextFloat3(-0.5f, 0.5f));
                m_Pack.Pack.motions[joint].velocity = new SoaFloat3(random.NextFloat3(-1f, 1f));
                m_Pack.scratch.airDamping[joint] = random.NextFloat(0.1f, 2f);
            }
        }

        [TearDown]
        public void FreePack() => m_Pack.Dispose();

        // Of x(u, v) = Σ w (r + S (c − p)) by small differences.
        [Test]
        public void NormalsOfTheSheet_AreThoseOfTheBlendedPlaces()
        {
            CellSheet.Evaluate(m_Pack.Pack, m_Pack.scratch);
            const float h = 1e-2f;
            Each((joint, next, u, v) =>
            {
                CellSheet sheet = default;
                CellSheet.Gather(&sheet, m_Pack.Pack, m_Pack.scratch, joint, next);

                // A parabola's slope is that of its chord.
                float3 alongU = (Place(joint, next, u + h, v) - Place(joint, next, u - h, v)) / (2f * h);
                float3 alongV = (Place(joint, next, u, v + h) - Place(joint, next, u, v - h)) / (2f * h),
                    normal = math.cross(alongV, alongU);
                Assert.That(math.distance(CellSheet.NormalAt(&sheet, u, v)[k_Lane], normal), Is.LessThan(1e-3f),
                    $"joint {joint} at {u}, {v}");
                float3 span = default;
                for (int k = 0; k < 4; k++)
                    span += Weight(k, u, v) * m_Pack.scratch.carriedFrames[Joint(k, joint, next)].c0[k_Lane];
                Assert.That(math.distance(CellSheet.SpanAt(&sheet, u, v)[k_Lane], span), Is.LessThan(1e-5f));
            });
        }

        // Each frame moves a rest point at its joint's height as a rigid body does, and all turn with the body about its centre.
        [Test]
        public void VelocitiesOfACell_AreTheBlendOfItsFramesMotions()
        {
            CellMotion.Evaluate(m_Pack.Pack, m_Pack.scratch);
            Each((joint, next, u, v) =>
            {
                CellMotion field = default;
                CellMotion.Gather(&field, m_Pack.scratch, joint, next);
                float x = 0.3f + u, z = -0.2f - v;
                float3 expected = default;
                for (int k = 0; k < 4; k++)
                {
                    int at = Joint(k, joint, next);
                    float3 rest = m_Pack.Pack.rig.restJoints[at], arm = Turned(at, new float3(x - rest.x, 0f, z - rest.z));
                    float3 own = m_Pack.scratch.drivenVelocities[at][k_Lane] - m_Pack.Pack.drivenLags[at][k_Lane]
                        + m_Pack.Pack.motions[at].velocity[k_Lane];
                    float3 turning = math.cross(m_Pack.scratch.carriedTurning[at][k_Lane], arm);
                    expected += Weight(k, u, v) * (own + turning
                        + math.cross(s_Spin, s_Hinge + m_Pack.scratch.carriedPositions[at][k_Lane] + arm));
                }

                Assert.That(math.distance(CellMotion.At(&field, u, v, x, z)[k_Lane], expected), Is.LessThan(1e-4f),
                    $"joint {joint} at {u}, {v}");
            });
        }

        // A body that moves by V and turns by W loses Σ b (n·(V + W × (r + h)))².
        [Test]
        public void DampingOfABody_TakesWhatItsJointsTakeAlongTheirNormals([Values(1u, 2u, 3u)] uint seed)
        {
            AirDamping.Evaluate(m_Pack.Pack, m_Pack.scratch);
            LaneAir* air = m_Pack.Pack.air;
            var random = Random.CreateFromIndex(seed);
            float3 v = random.NextFloat3(-1f, 1f), w = random.NextFloat3(-1f, 1f), otherV = random.NextFloat3(-1f, 1f),
                otherW = random.NextFloat3(-1f, 1f);
            double expected = 0.0;
            for (int joint = 0; joint < m_Pack.rig.JointCount; joint++)
            {
                float3 n = m_Pack.scratch.carriedFrames[joint].c1[k_Lane], arm = m_Pack.scratch.carriedPositions[joint][k_Lane] + s_Hinge;
                expected += m_Pack.scratch.airDamping[joint][k_Lane] * math.dot(n, v + math.cross(w, arm)) * math.dot(n, otherV
                    + math.cross(otherW, arm));
            }

            float3 coupled = Times(air->uw, otherW), back = Times(air->uw, w);
            double taken = math.dot(v, Times(air->uu, otherV)) + math.dot(w, Times(air->ww, otherW)) + math.dot(v, coupled)
                + math.dot(otherV, back);
            Assert.That(taken, Is.EqualTo(expected).Within(1e-3));
            Assert.That(math.dot(v, Times(air->uu, v)) + 2f * math.dot(v, back) + math.dot(w, Times(air->ww, w)),
                Is.GreaterThanOrEqualTo(0f));
        }

        private delegate void AtCell(int joint, int next, float u, float v);

        private void Each(AtCell check)
        {
            int joints = m_Pack.Pack.rig.jointsPerChain;
            for (int chain = 0; chain + 1 < m_Pack.Pack.rig.chainCount; chain++)
            {
                for (int j = 0; j + 1 < joints; j++)
                {
                    int joint = chain * joints + j;
                    foreach (float2 at in new[] { new float2(0f, 0f), new float2(0.3f, 0.8f), new float2(0.9f, 0.1f), new float2(1f, 1f) })
                        check(joint, joint + joints, at.x, at.y);
                }
            }
        }

        private float3 Place(int joint, int next, float u, float v)
        {
            float3 rest = default, place = default;
            for (int k = 0; k < 4; k++)
                rest += Weight(k, u, v) * m_Pack.Pack.rig.restJoints[Joint(k, joint, next)];
            for (int k = 0; k < 4; k++)
            {
                int at = Joint(k, joint, next);
                place += Weight(k, u, v) * (m_Pack.scratch.carriedPositions[at][k_Lane]
                    + Turned(at, rest - m_Pack.Pack.rig.restJoints[at]));
            }

            return place;
        }

        private float3 Turned(int joint, float3 offset) => Times(m_Pack.scratch.carriedFrames[joint], offset);

        private static float3 Times(in SoaFloat3x3 m, float3 v) => m.c0[k_Lane] * v.x + m.c1[k_Lane] * v.y + m.c2[k_Lane] * v.z;

        // Corners of a cell: its first joint, the next on its chain, and both on the next chain; u goes across chains.
        private static int Joint(int corner, int joint, int next) => (corner < 2 ? joint : next) + corner % 2;

        private static float Weight(int corner, float u, float v) => (corner < 2 ? 1f - u : u) * (corner % 2 == 0 ? 1f - v : v);

        private static SoaQuaternion Rotation(quaternion q) => new SoaQuaternion(new SoaFloat3(q.value.xyz), q.value.w);
    }
}
