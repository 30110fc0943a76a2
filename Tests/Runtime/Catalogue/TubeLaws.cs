using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of slices, tubes, trunks and stalks, of which bodies are made, against the ellipses that they say they are.</summary>
    public sealed class TubeLaws
    {
        private const int k_Sides = 12;

        private static CrossSection Section(ref Random random, float z) => new CrossSection(
            new Vector3(0f, random.NextFloat(-0.5f, 0.5f), z), random.NextFloat(0.5f, 2f), random.NextFloat(0.5f, 2f),
            random.NextFloat(0.5f, 2f), random.NextFloat(0f, 0.4f));

        [Test]
        public void TheRimOfASlice_IsTwoHalfEllipses_BentByItsArch()
        {
            var random = new Random(3);
            for (int trial = 0; trial < 20; trial++)
            {
                CrossSection slice = Section(ref random, 0f);
                for (int k = 0; k < 40; k++)
                {
                    double angle = 2 * Math.PI * k / 40;
                    Vector2 rim = slice.Rim((float)Math.Sin(angle), (float)Math.Cos(angle));
                    double height = Math.Cos(angle) > 0 ? slice.Above : slice.Below, x = rim.x / slice.HalfWidth;
                    double y = (rim.y - slice.Arch * (1 - x * x)) / height;
                    Assert.That(x * x + y * y, Is.EqualTo(1).Within(1e-5));
                    Assert.That(Math.Sign(Math.Round(x, 5)), Is.EqualTo(Math.Sign(Math.Round(Math.Sin(angle), 5))), "clockwise");
                    Assert.That(y, Is.EqualTo(Math.Cos(angle)).Within(1e-5), "from straight up");
                }
            }
        }

        [Test]
        public void TheGirthOfASlice_IsTheLengthOfItsRim()
        {
            var random = new Random(7);
            for (int trial = 0; trial < 20; trial++)
            {
                float width = random.NextFloat(0.4f, 2f), height = random.NextFloat(0.4f, 2f), arch = random.NextFloat(0.1f, 1f);
                var slice = new CrossSection(default, width, height, height);
                double half = 0.0;
                for (int k = 0; k < 2000; k++)
                    half += (Rim(slice, Math.PI * (k + 1) / 2000) - Rim(slice, Math.PI * k / 2000)).magnitude;

                Assert.That(slice.HalfGirth, Is.EqualTo(half).Within(0.3).Percent);
                Assert.That(new CrossSection(default, width, height, height, -arch).HalfGirth,
                    Is.EqualTo(slice.HalfGirth + 2f * arch).Within(1e-5f), "up to the arch and down again");
                Assert.That(new CrossSection(default, width, 1.5f * height, 0.5f * height).HalfGirth,
                    Is.EqualTo(slice.HalfGirth).Within(1e-5f), "by the mean of both heights");
            }
        }

        [Test]
        public void ASwollenSlice_IsLargerAboutItsCentre_WithTheArchItHad()
        {
            var slice = new CrossSection(new Vector3(1f, 2f, 3f), 4f, 5f, 6f, 7f);
            CrossSection swollen = slice.Swollen(3f);

            Assert.That((swollen.Centre, swollen.HalfWidth, swollen.Above, swollen.Below, swollen.Arch),
                Is.EqualTo((slice.Centre, 12f, 15f, 18f, 7f)));
            Assert.That((CrossSection.Round(default, 0f).IsPoint, CrossSection.Round(default, 1e-3f).IsPoint), Is.EqualTo((true, false)));
        }

        [Test]
        public void AStraightTube_HasItsSlicesWhereTheyAre_UprightAndClosed()
        {
            var random = new Random(11);
            for (int trial = 0; trial < 10; trial++)
            {
                float[] places = { 0f, 1f, 2.5f, 6f, 7f };
                CrossSection[] slices = Array.ConvertAll(places, z =>
                {
                    CrossSection made = Section(ref random, z);
                    return new CrossSection(new Vector3(0.3f, -0.7f, z), made.HalfWidth, made.Above, made.Below, made.Arch);
                });
                slices[0] = CrossSection.Round(slices[0].Centre, 0f);
                slices[4] = CrossSection.Round(slices[4].Centre, 0f);
                BodyPart tube = Tube.Along(slices, k_Sides);

                Assert.That(tube.Positions, Has.Length.EqualTo(2 + 3 * k_Sides));
                Assert.That(tube.Extent.y, Is.EqualTo(7f).Within(1e-5f));
                Assert.That(tube.Extent.x, Is.EqualTo(slices.Max(slice => slice.HalfGirth)).Within(1e-5f));
                for (int ring = 1; ring < 4; ring++)
                {
                    for (int side = 0; side < k_Sides; side++)
                    {
                        int vertex = 1 + (ring - 1) * k_Sides + side;
                        Vector3 off = tube.Positions[vertex] - slices[ring].Centre;
                        Vector2 rim = Rim(slices[ring], 2 * Math.PI * side / k_Sides);
                        Assert.That((off - new Vector3(rim.x, rim.y, 0f)).magnitude, Is.LessThan(1e-5f), "seen from behind, clockwise");
                        float around = 1f - Math.Abs(2f * side / k_Sides - 1f);
                        Assert.That(tube.Uvs[vertex].x, Is.EqualTo(around).Within(1e-6f), "0 above, 1 below, on both sides");
                        Assert.That(tube.Uvs[vertex].y, Is.EqualTo(places[ring] / 7f).Within(1e-6f));
                    }
                }

                Assert.That((tube.Uvs[0], tube.Uvs[tube.Uvs.Length - 1]), Is.EqualTo((new Vector2(0.5f, 0f), new Vector2(0.5f, 1f))));
                SurfaceMesh mesh = Mesh(tube);
                Assert.That(BodyPieces.Of(mesh), Has.Count.EqualTo(1));
                Assert.That(BodyPieces.Volume(mesh, BodyPieces.Of(mesh)[0]), Is.Positive);
                Assert.That(BodyPieces.Winding(mesh, BodyPieces.Of(mesh)[0], slices[2].Centre), Is.EqualTo(1).Within(1e-4), "closed");
            }
        }

        [Test]
        public void TheTrianglesOfBothHalves_AreMirrorImages()
        {
            var random = new Random(13);
            CrossSection[] slices = Enumerable.Range(0, 5).Select(k => Section(ref random, k)).ToArray();
            slices[0] = CrossSection.Round(slices[0].Centre, 0f);
            BodyPart tube = Tube.Along(slices, k_Sides);
            var triangles = new HashSet<(int, int, int)>();
            for (int corner = 0; corner < tube.Triangles.Length; corner += 3)
                triangles.Add(Turned(tube.Triangles[corner], tube.Triangles[corner + 1], tube.Triangles[corner + 2]));

            Assert.That(triangles, Has.Count.EqualTo(k_Sides + 3 * 2 * k_Sides));
            foreach ((int a, int b, int c) in triangles)
                Assert.That(triangles, Does.Contain(Turned(Twin(a), Twin(c), Twin(b))), $"{a} {b} {c}");
        }

        [Test]
        public void ACurvedTube_KeepsItsSlicesSquareToItsWay_AndTheirUpAsNearAsItCan()
        {
            // A quarter of a circle of radius 10 in the plane of X and Z.
            CrossSection[] slices = Enumerable.Range(0, 31).Select(k => CrossSection.Round(
                new Vector3(10f - 10f * (float)Math.Cos(Math.PI * k / 60), 0f, 10f * (float)Math.Sin(Math.PI * k / 60)), 1f)).ToArray();
            BodyPart tube = Tube.Along(slices, k_Sides);
            for (int ring = 0; ring < slices.Length; ring++)
            {
                Vector3 along = slices[Math.Min(ring + 1, 30)].Centre - slices[Math.Max(ring - 1, 0)].Centre;
                for (int side = 0; side < k_Sides; side++)
                {
                    Vector3 off = tube.Positions[ring * k_Sides + side] - slices[ring].Centre;
                    Assert.That(off.magnitude, Is.EqualTo(1f).Within(1e-4f));
                    Assert.That(Vector3.Dot(off, along) / along.magnitude, Is.Zero.Within(1e-4f));
                    Assert.That(off.y, Is.EqualTo((float)Math.Cos(2 * Math.PI * side / k_Sides)).Within(1e-4f));
                }
            }

            Assert.That(tube.Extent.y, Is.EqualTo(10 * Math.PI / 2).Within(0.1).Percent);
        }

        [Test]
        public void BetweenKeysOnALine_ATrunkLiesOnIt_InEveryMeasure()
        {
            // Places, arches and squares of sizes are all linear along it, as the curves through them then are.
            CrossSection Key(float t) => new CrossSection(new Vector3(2f + t, 3f - 2f * t, 5f * t), (float)Math.Sqrt(1 + t),
                (float)Math.Sqrt(2 + 3 * t), (float)Math.Sqrt(4 - t), 0.5f - 0.25f * t);
            CrossSection[] keys = { Key(0f), Key(0.3f), Key(1.1f), Key(2f) };
            CrossSection[] plain = Trunk.Sections(keys, 20), swollen = Trunk.Sections(keys, 20, t => 1f + t);

            Assert.That((plain[0].Centre, plain[20].Centre), Is.EqualTo((keys[0].Centre, keys[3].Centre)));
            Assert.That(plain[0].IsPoint && plain[20].IsPoint);
            for (int ring = 1; ring < 20; ring++)
            {
                float t = plain[ring].Centre.z / 5f;
                CrossSection expected = Key(t);
                Assert.That((plain[ring].Centre - expected.Centre).magnitude, Is.LessThan(1e-5f));
                Assert.That(plain[ring].HalfWidth, Is.EqualTo(expected.HalfWidth).Within(1e-5f));
                Assert.That(plain[ring].Above, Is.EqualTo(expected.Above).Within(1e-5f));
                Assert.That(plain[ring].Below, Is.EqualTo(expected.Below).Within(1e-5f));
                Assert.That(plain[ring].Arch, Is.EqualTo(expected.Arch).Within(1e-5f));
                Assert.That(swollen[ring].HalfWidth, Is.EqualTo((1f + 0.5f * t) * expected.HalfWidth).Within(1e-5f), "relief");

                // Crowded at the ends: 0.4 of even spacing and 0.6 of that on a circle.
                double even = ring / 20.0, round = 0.5 - 0.5 * Math.Cos(Math.PI * even);
                Assert.That(0.5f * t, Is.EqualTo(0.4 * even + 0.6 * round).Within(1e-5));
            }
        }

        [Test]
        public void AStalk_IsAsThickAsAsked_FromEndToEnd()
        {
            Vector3[] straight = { default, new Vector3(0f, 0f, 10f), new Vector3(0f, 0f, 20f), new Vector3(0f, 0f, 30f) };
            BodyPart stalk = Stalk.Along(straight, t => 1f - 0.5f * t, 10, 8);

            Assert.That(stalk.Positions, Has.Length.EqualTo(2 + 11 * 8));
            Assert.That((stalk.Positions[0], stalk.Positions[89]), Is.EqualTo((straight[0], straight[3])));
            float before = 0f;
            foreach (Vector3 place in stalk.Positions.Skip(1).Take(88))
            {
                Assert.That(new Vector2(place.x, place.y).magnitude, Is.EqualTo(1f - 0.5f * place.z / 30f).Within(1e-4f));
                Assert.That(place.z, Is.GreaterThanOrEqualTo(before));
                before = place.z;
            }

            Assert.That((30f - before, stalk.Positions[1].z), Is.EqualTo((0.12f, 0.12f)).Using<(float, float)>(
                (one, other) => Math.Abs(one.Item1 - other.Item1) + Math.Abs(one.Item2 - other.Item2) < 1e-3f ? 0 : 1), "blunt ends");
        }

        [Test]
        public void ALeg_PassesNearItsJoints_AndIsAsThickAtEachAsAsked()
        {
            Vector3[] joints = { default, new Vector3(3f, 1f, 0f), new Vector3(4f, -4f, 1f), new Vector3(6f, -5f, 1f) };
            float[] radii = { 0.5f, 0.4f, 0.3f, 0.2f };
            BodyPart leg = Stalk.Leg(joints, radii, 8);
            Vector3[] middles = Enumerable.Range(0, 8).Select(ring => leg.Positions.Skip(1 + 8 * ring).Take(8)
                .Aggregate(Vector3.zero, (sum, place) => sum + place / 8f)).ToArray();

            // A ring at either end; three at each knee: where the bend begins, in its middle and where it ends.
            Assert.That(leg.Positions, Has.Length.EqualTo(2 + 8 * 8));
            Assert.That((leg.Positions[0], leg.Positions[65]), Is.EqualTo((joints[0], joints[3])));
            int[] jointOf = { 0, 1, 1, 1, 2, 2, 2, 3 };
            for (int ring = 0; ring < 8; ring++)
            {
                for (int side = 0; side < 8; side++)
                {
                    Assert.That((leg.Positions[1 + 8 * ring + side] - middles[ring]).magnitude,
                        Is.EqualTo(radii[jointOf[ring]]).Within(1e-4f));
                }
            }

            for (int knee = 1; knee <= 2; knee++)
            {
                Vector3 begins = middles[3 * knee - 2], middle = middles[3 * knee - 1], ends = middles[3 * knee];
                Assert.That((begins - Vector3.Lerp(joints[knee], joints[knee - 1], 0.14f)).magnitude, Is.LessThan(1e-4f));
                Assert.That((ends - Vector3.Lerp(joints[knee], joints[knee + 1], 0.14f)).magnitude, Is.LessThan(1e-4f));
                Assert.That((middle - (0.25f * begins + 0.5f * joints[knee] + 0.25f * ends)).magnitude, Is.LessThan(1e-4f), "a parabola");
            }

            Assert.That(middles[0].magnitude, Is.EqualTo(0.01f * joints[1].magnitude).Within(1e-4f));
            Assert.That((middles[7] - joints[3]).magnitude, Is.EqualTo(0.05f * (joints[3] - joints[2]).magnitude).Within(1e-4f));
        }

        [Test]
        public void ABezierCurve_IsItsRepeatedLerp()
        {
            Vector3[] curve = { new Vector3(1f, 2f, 3f), new Vector3(-4f, 0f, 2f), new Vector3(5f, 6f, -7f), new Vector3(0f, 3f, 9f) };
            for (float t = 0f; t <= 1f; t += 0.125f)
            {
                Vector3[] left = curve;
                while (left.Length > 1)
                    left = Enumerable.Range(0, left.Length - 1).Select(k => Vector3.Lerp(left[k], left[k + 1], t)).ToArray();
                Assert.That((Stalk.Bezier(curve, t) - left[0]).magnitude, Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void AShell_IsAsWideThickAndArchedAsAsked_AndBowsAwayFromItsEnds()
        {
            Vector3 start = new Vector3(1f, 2f, 3f), along = new Vector3(0f, 0f, -8f);
            BodyPart shell = Shell.Along(start, along, new Vector3(0f, 2f, 1f), t => 1f + t, 0.5f, 0.2f, 0.6f, 16, 8);

            Assert.That((shell.Positions[0], shell.Positions[shell.Positions.Length - 1]), Is.EqualTo((start, start + along)));
            for (int ring = 1; ring < 16; ring++)
            {
                Vector3[] rim = shell.Positions.Skip(1 + 8 * (ring - 1)).Take(8).ToArray();
                float t = 0.5f - 0.5f * (float)Math.Cos(Math.PI * ring / 16), bow = 4f * t * (1f - t) * 0.6f;
                Vector3 centre = start + t * along + new Vector3(0f, bow, 0f);
                Assert.That((rim[2] - rim[6]).magnitude, Is.EqualTo(2f * (1f + t)).Within(1e-4f), "from rim to rim");
                Assert.That(((rim[2] + rim[6]) / 2f - centre).magnitude, Is.LessThan(1e-4f));
                Assert.That((rim[0] - rim[4]).magnitude, Is.EqualTo(0.2f).Within(1e-4f), "thick in the middle");
                Assert.That(((rim[0] + rim[4]) / 2f - centre).magnitude, Is.EqualTo(0.5f * (1f + t)).Within(1e-4f), "arched");
                Assert.That(rim[0].y, Is.GreaterThan(centre.y), "upwards");
            }
        }

        private static Vector2 Rim(in CrossSection slice, double angle) => slice.Rim((float)Math.Sin(angle), (float)Math.Cos(angle));

        private static SurfaceMesh Mesh(BodyPart part) =>
            new SurfaceMesh { positions = part.Positions, normals = part.Normals, triangles = part.Triangles };

        // Of a tube whose first slice is a point.
        private static int Twin(int vertex)
        {
            if (vertex == 0)
                return 0;
            int ring = (vertex - 1) / k_Sides, side = (vertex - 1) % k_Sides;
            return 1 + ring * k_Sides + (k_Sides - side) % k_Sides;
        }

        private static (int, int, int) Turned(int a, int b, int c) =>
            a < b && a < c ? (a, b, c) : b < c ? (b, c, a) : (c, a, b);
    }
}
