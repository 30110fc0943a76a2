using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Sums of masses: centre and inertia, parallel axes, and sums of sums.</summary>
    public sealed class MassSumLaws
    {
        // J = Σ m ((r·r) 1 − r rᵀ) about the centre, and of an ellipsoid m/5 (b² + c²) about its own axes besides.
        [Test]
        public void AnEllipsoidInMillimetres_IsInMetres_AndGrowsWithItsInsect()
        {
            var part = BodyEllipsoid.Millimetres(1.0, -2.0, 3.0, 4.0, 5.0, 6.0, 0.25f);

            Assert.That(part.centre, Is.EqualTo(new UnityEngine.Vector3(0.001f, -0.002f, 0.003f)));
            Assert.That(part.halfAxes, Is.EqualTo(new UnityEngine.Vector3(0.004f, 0.005f, 0.006f)));
            Assert.That(part.share, Is.EqualTo(0.25f));
            BodyEllipsoid large = part.Scaled(2f);
            Assert.That((large.centre, large.halfAxes, large.share), Is.EqualTo((2f * part.centre, 2f * part.halfAxes, 0.25f)));
        }

        [Test]
        public void Inertia_IsThatOfItsParts_AboutTheCentre([Values(1u, 2u, 3u, 4u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            var sum = new MassSum();
            double whole = 0;
            double[] mass = new double[6], first = new double[3];
            var at = new float3[6];
            var half = new float3[6];
            for (int k = 0; k < 6; k++)
            {
                mass[k] = random.NextFloat(0.1f, 2f);
                at[k] = random.NextFloat3(-1f, 1f) + 0.5f;
                half[k] = k % 2 == 0 ? default : random.NextFloat3(0.1f, 1f);
                sum.Add(mass[k], at[k], half[k]);
                whole += mass[k];
                for (int i = 0; i < 3; i++)
                    first[i] += mass[k] * at[k][i];
            }

            var centre = new float3((float)(first[0] / whole), (float)(first[1] / whole), (float)(first[2] / whole));
            float3x3 inertia = default;
            for (int k = 0; k < 6; k++)
            {
                float3 r = at[k] - centre, own = half[k] * half[k] / 5f;
                float3x3 part = math.dot(r, r) * float3x3.identity - new float3x3(r * r.x, r * r.y, r * r.z);
                part.c0.x += own.y + own.z;
                part.c1.y += own.x + own.z;
                part.c2.z += own.x + own.y;
                inertia += (float)mass[k] * part;
            }

            Assert.That(sum.Mass, Is.EqualTo(whole).Within(1e-9));
            Assert.That(math.distance(sum.Centre, centre), Is.LessThan(1e-5f));
            for (int column = 0; column < 3; column++)
                Assert.That(math.distance(sum.Inertia[column], inertia[column]), Is.LessThan(1e-4f));
        }

        [Test]
        public void Moved_ASumKeepsTheInertiaAboutItsCentre()
        {
            var by = new float3(3f, -2f, 5f);
            MassSum here = Points(4, default), there = Points(4, by);
            Assert.That(math.distance(there.Centre, here.Centre + by), Is.LessThan(1e-5f));
            for (int column = 0; column < 3; column++)
                Assert.That(math.distance(there.Inertia[column], here.Inertia[column]), Is.LessThan(1e-4f));
        }

        // A wing's sum on the body, turned, scaled, mirrored, moved and weighed, is the sum of its points there.
        [Test]
        public void ASumOfAnother_IsTheSumOfItsMovedPoints([Values(false, true)] bool mirrored)
        {
            var random = Random.CreateFromIndex(3);
            float3x3 axes = 0.6f * new float3x3(random.NextQuaternionRotation());
            axes.c0 *= mirrored ? -1f : 1f;
            var at = new float3(0.3f, -0.2f, 0.7f);
            MassSum points = Points(5, default), sum = new MassSum(), expected = new MassSum();
            sum.Add(2.0, new float3(1f, 0f, 0f), new float3(0.1f, 0.2f, 0.3f));
            expected.Add(2.0, new float3(1f, 0f, 0f), new float3(0.1f, 0.2f, 0.3f));
            sum.Add(0.25, points, axes, at);
            Points(5, default, (mass, place) => expected.Add(0.25 * mass, math.mul(axes, place) + at, default));
            Assert.That(sum.Mass, Is.EqualTo(expected.Mass).Within(1e-9));
            Assert.That(math.distance(sum.Centre, expected.Centre), Is.LessThan(1e-5f));
            for (int column = 0; column < 3; column++)
                Assert.That(math.distance(sum.Inertia[column], expected.Inertia[column]), Is.LessThan(1e-5f));
        }

        private static MassSum Points(int count, float3 by)
        {
            var sum = new MassSum();
            Points(count, by, (mass, at) => sum.Add(mass, at, default));
            return sum;
        }

        private static void Points(int count, float3 by, System.Action<double, float3> add)
        {
            var random = Random.CreateFromIndex(7);
            for (int k = 0; k < count; k++)
                add(random.NextFloat(0.1f, 1f), random.NextFloat3(-1f, 1f) + by);
        }
    }
}
