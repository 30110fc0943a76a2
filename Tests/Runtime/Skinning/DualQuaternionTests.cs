using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class DualQuaternionTests
    {
        [Test]
        public void Blend_OfTwoTransforms_MovesThePointWhereItShould()
        {
            var a = new DualQuaternion(quaternion.RotateZ(math.radians(40f)), new float3(1f, 0f, 0f));
            var b = new DualQuaternion(quaternion.RotateX(math.radians(-20f)), new float3(0f, 0.5f, 0.2f));
            foreach (float sign in new[] { 1f, -1f })
            {
                var turned = new DualQuaternion { real = sign * b.real, dual = sign * b.dual };
                CellBlend blend = default;
                blend.Set(a, turned, a, turned);
                AssertPoint(blend, 0.7f);
            }
        }

        [Test]
        public void Swing_IsTheCheckedOne()
        {
            SoaQuaternion swing = SoaQuaternion.Swing(Lanes.All(1f, 0f, 0f), new SoaFloat3(math.normalize(new float3(1f, 0.4f, -0.2f))));
            float4 q = swing[0].value;
            Assert.That(q.w, Is.EqualTo(0.977975).Within(Lanes.CheckTolerance));
            Assert.That(q.x, Is.Zero.Within(Lanes.CheckTolerance));
            Assert.That(q.y, Is.EqualTo(0.093343).Within(Lanes.CheckTolerance));
            Assert.That(q.z, Is.EqualTo(0.186686).Within(Lanes.CheckTolerance));
        }

        private static unsafe void AssertPoint(CellBlend blend, float v)
        {
            var quad = new SkinQuad { u = 0.4f, v = v, px = 0.3f, py = 0.4f, pz = 0.5f, nx = 0f, ny = 1f, nz = 0f, target = new int4(0, 1, 2, 3) };
            SkinnedVertex* vertices = stackalloc SkinnedVertex[5];
            var target = new SkinTarget { vertices = vertices };
            target.rig.skinQuads = &quad;
            SoaBounds bounds = SoaBounds.Empty;
            DualQuaternionSkinning.Cell(&blend, target, 0, 1, &bounds);
            for (int lane = 0; lane < 4; lane++)
            {
                Assert.That(vertices[lane].position.x, Is.EqualTo(0.457896).Within(Lanes.CheckTolerance));
                Assert.That(vertices[lane].position.y, Is.EqualTo(0.83585).Within(Lanes.CheckTolerance));
                Assert.That(vertices[lane].position.z, Is.EqualTo(0.551374).Within(Lanes.CheckTolerance));
                Assert.That(bounds.max.x[lane], Is.EqualTo(vertices[lane].position.x));
            }
        }
    }
}
