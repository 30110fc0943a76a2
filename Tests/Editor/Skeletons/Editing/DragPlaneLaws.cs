using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the point of a plane to which a ray drags a joint.</summary>
    public sealed class DragPlaneLaws
    {
        private static readonly Vector3 s_Anchor = new Vector3(1f, 2f, -1f);

        // Of the angle between ray and plane: from three degrees on the ray is met, below that the plane is seen edge on.
        [TestCase(0.2f, true)]
        [TestCase(0.051f, true)]
        [TestCase(0.049f, false)]
        [TestCase(0f, false)]
        public void APoint_LiesInThePlane_AndOnTheRay_UnlessThePlaneIsSeenEdgeOn(float sine, bool isOnRay)
        {
            foreach (float length in new[] { 1e-20f, 1f, 1e15f })
            {
                Vector3 normal = new Vector3(1f, 2f, 2f).normalized, along = Vector3.Cross(normal, Vector3.up).normalized;
                Vector3 direction = Mathf.Sqrt(1f - sine * sine) * along - sine * normal;
                var over = Vector3.Cross(along, normal);
                var ray = new Ray(s_Anchor + 0.1f * normal + 0.3f * over - 3f * along, direction);
                Assert.That(DragPlane.TryPoint(ray, s_Anchor, length * normal, out Vector3 point), Is.True);
                Assert.That(Vector3.Dot(point - s_Anchor, normal), Is.EqualTo(0f).Within(1e-4f));
                float off = Vector3.Cross(point - ray.origin, direction).magnitude;
                Assert.That(off < 2e-4f, Is.EqualTo(isOnRay), $"{off}");
                Assert.That(Vector3.Dot(point - s_Anchor, over), Is.EqualTo(0.3f).Within(1e-3f), "to the side as the ray");
                if (!isOnRay)
                    Assert.That(Vector3.Dot(point - s_Anchor, along), Is.EqualTo(0f).Within(0.02f), "as far ahead as the joint");
            }
        }

        [Test]
        public void APlaneBehindTheEye_IsNotMet_AndTheJointStays()
        {
            var ray = new Ray(s_Anchor + 2f * Vector3.up, Vector3.up);
            Assert.That(DragPlane.TryPoint(ray, s_Anchor, Vector3.up, out Vector3 point), Is.False);
            Assert.That(point, Is.EqualTo(s_Anchor));
            Assert.That(DragPlane.TryPoint(new Ray(ray.origin, Vector3.down), s_Anchor, Vector3.up, out point), Is.True);
            Assert.That(Vector3.Distance(point, s_Anchor), Is.LessThan(1e-5f));
        }
    }
}
