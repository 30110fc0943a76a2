using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class JointPathLaws
    {
        // As far from the ray's line as the nearest of many points of the path and of the lines of its end bones.
        [Test]
        public void ClosestPoint_IsTheNearestOfThePath([NUnit.Framework.Range(1, 60)] int seed)
        {
            var random = new System.Random(seed);
            Vector3 Next() => new Vector3(Signed(random), Signed(random), Signed(random));
            var joints = new Vector3[2 + seed % 5];
            for (int k = 0; k < joints.Length; k++)
                joints[k] = new Vector3(k, 0f, 0f) + Next();
            var path = new JointPath(joints);
            Vector3 origin = 3f * Next(), direction = Next().normalized;

            float found = Distance(path.At(path.ClosestTo(origin, direction)), origin, direction), least = float.PositiveInfinity;
            for (float at = -20f; at < path.Length + 20f; at += 0.01f)
                least = Mathf.Min(least, Distance(path.At(at), origin, direction));

            Assert.That(found, Is.LessThan(least + 1e-4f));
        }

        private static float Distance(Vector3 place, Vector3 origin, Vector3 direction) =>
            Vector3.Cross(place - origin, direction).magnitude;

        private static float Signed(System.Random random) => 2f * (float)random.NextDouble() - 1f;
    }
}
