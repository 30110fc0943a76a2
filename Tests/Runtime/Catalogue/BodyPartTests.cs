using System;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    public sealed class BodyPartTests
    {
        [Test]
        public void AnEllipsoid_HasAnEllipsoidsVolumeAndNormals()
        {
            var random = new Random(5);
            for (int trial = 0; trial < 20; trial++)
            {
                var radii = new Vector3(random.NextFloat(0.2f, 5f), random.NextFloat(0.2f, 5f), random.NextFloat(0.2f, 5f));
                var centre = new Vector3(random.NextFloat(-5f, 5f), random.NextFloat(-5f, 5f), random.NextFloat(-5f, 5f));
                BodyPart part = Ellipsoid.Around(centre, radii, 40, 40);
                SurfaceMesh mesh = Mesh(part);

                Assert.That(BodyPieces.Volume(mesh, BodyPieces.Of(mesh)[0]),
                    Is.EqualTo(4 * Math.PI / 3 * radii.x * radii.y * radii.z).Within(2).Percent);
                for (int vertex = 1; vertex + 1 < part.Positions.Length; vertex++)
                {
                    Vector3 away = part.Positions[vertex] - centre;
                    var gradient = new Vector3(away.x / (radii.x * radii.x), away.y / (radii.y * radii.y), away.z / (radii.z * radii.z));
                    Assert.That(Vector3.Dot(part.Normals[vertex], gradient.normalized), Is.GreaterThan(0.93f));
                }
            }
        }

        [Test]
        public void ATrunk_PassesThroughItsKeys_AndIsRoundAtItsEnds()
        {
            CrossSection[] keys = new[]
            {
                new CrossSection(new Vector3(0f, 0f, 2f), 0f, 0f, 0f), CrossSection.Round(new Vector3(0f, 0f, 0f), 2f),
                new CrossSection(new Vector3(0f, 0f, -2f), 0f, 0f, 0f),
            };

            foreach (CrossSection section in Trunk.Sections(keys, 24))
            {
                double ball = Math.Sqrt(Math.Max(4 - section.Centre.z * section.Centre.z, 0));
                Assert.That(section.HalfWidth, Is.EqualTo(ball).Within(0.35), "a blunt end, near that of a ball");
                Assert.That(section.HalfWidth, Is.LessThanOrEqualTo(2.0001f));
            }
        }

        [Test]
        public void ACurvedTube_IsAsThickAsItsSections_EverywhereAlongIt()
        {
            var random = new Random(17);
            for (int trial = 0; trial < 20; trial++)
            {
                var curve = new Vector3[4];
                for (int k = 0; k < 4; k++)
                {
                    curve[k] = new Vector3(random.NextFloat(-2f, 2f), random.NextFloat(-2f, 2f), 5f * k + random.NextFloat(-1f, 1f));
                }

                BodyPart stalk = Stalk.Along(curve, t => 0.3f, 30, 8);
                foreach (Vector3 place in stalk.Positions)
                {
                    Assert.That(DistanceTo(curve, place), Is.LessThan(0.303f));
                }

                Assert.That(stalk.Extent.y, Is.GreaterThan(0.98f * (curve[3] - curve[0]).magnitude));
                Assert.That(stalk.Extent.x, Is.EqualTo(0.3 * Math.PI).Within(1).Percent);
            }
        }

        [Test]
        public void AShell_IsThin_AndBulgesTowardsItsUpperSide()
        {
            var up = new Vector3(0f, 1f, 0f);
            BodyPart shell = Shell.Along(default, new Vector3(6f, 0f, 0f), up, t => (float)Math.Sin(Math.PI * t), 0.4f, 0.1f, 0.3f, 20, 16);
            SurfaceMesh mesh = Mesh(shell);

            double volume = BodyPieces.Volume(mesh, BodyPieces.Of(mesh)[0]);
            Assert.That(volume, Is.InRange(0.2, 0.9), "a sheet of 7.6 mm² and up to 0.1 mm");
            foreach (Vector3 place in shell.Positions)
            {
                Assert.That(place.y, Is.InRange(-0.06f, 0.76f));
            }
        }

        [Test]
        public void Hair_StandsOnTheRightSideOfTheSkin_WhereItMay()
        {
            BodyPart skin = Ellipsoid.Around(default, new Vector3(2f, 2f, 2f), 20, 20);
            BodyPart fur = new Fur { Count = 60, Length = 0.5f, Radius = 0.05f, Seed = 3, Where = place => place.y > 0f }.GrowOn(skin);

            Assert.That(fur.Triangles, Has.Length.EqualTo(60 * 4 * 3));
            for (int hair = 0; hair < 60; hair++)
            {
                Vector3 root = (fur.Positions[4 * hair] + fur.Positions[4 * hair + 1] + fur.Positions[4 * hair + 2]) / 3f;
                Vector3 tip = fur.Positions[4 * hair + 3];
                Assert.That(root.x, Is.GreaterThan(-0.2f));
                Assert.That(root.y, Is.GreaterThan(-0.3f));
                Assert.That(root.magnitude, Is.LessThan(2f), "rooted in the skin");
                Assert.That(tip.magnitude, Is.GreaterThan(2f), "stands off it");
                Assert.That((tip - root).magnitude, Is.InRange(0.3f, 0.8f));
            }
        }

        [Test]
        public void Hair_IsTheSame_EachTime()
        {
            BodyPart skin = Ellipsoid.Around(default, new Vector3(2f, 2f, 2f), 20, 20);
            BodyPart first = new Fur { Count = 20, Length = 0.5f, Radius = 0.05f, Seed = 9 }.GrowOn(skin);
            BodyPart again = new Fur { Count = 20, Length = 0.5f, Radius = 0.05f, Seed = 9 }.GrowOn(skin);
            BodyPart other = new Fur { Count = 20, Length = 0.5f, Radius = 0.05f, Seed = 10 }.GrowOn(skin);

            Assert.That(again.Positions, Is.EqualTo(first.Positions));
            Assert.That(other.Positions, Is.Not.EqualTo(first.Positions));
        }

        [Test]
        public void Shelves_HoldEveryPart_ApartFromTheOthers_AllToOneScale()
        {
            var random = new Random(29);
            for (int trial = 0; trial < 50; trial++)
            {
                var extents = new List<Vector2>();
                for (int part = random.NextInt(1, 40); part > 0; part--)
                {
                    extents.Add(new Vector2(random.NextFloat(0.05f, 8f), random.NextFloat(0.05f, 30f)));
                }

                Rect[] shelves = UvShelves.Lay(extents);
                foreach (float unit in new[] { 0.01f, 1000f })
                {
                    Rect[] others = UvShelves.Lay(extents.ConvertAll(extent => unit * extent));
                    for (int part = 0; part < others.Length; part++)
                        Assert.That(others[part].height, Is.EqualTo(shelves[part].height).Within(1e-5), $"in units of 1/{unit}");
                }

                float scale = shelves[0].height / extents[0].y;
                for (int one = 0; one < shelves.Length; one++)
                {
                    Assert.That(shelves[one].height, Is.EqualTo(scale * extents[one].y).Within(1e-4));
                    Assert.That(shelves[one].width, Is.EqualTo(scale * extents[one].x).Within(1e-4));
                    Assert.That(shelves[one].xMin >= 0f && shelves[one].yMin >= 0f && shelves[one].xMax <= 1f && shelves[one].yMax <= 1f);
                    for (int other = one + 1; other < shelves.Length; other++)
                    {
                        Assert.That(shelves[one].Overlaps(shelves[other]), Is.False);
                    }
                }
            }
        }

        private static SurfaceMesh Mesh(BodyPart part)
        {
            return new SurfaceMesh { positions = part.Positions, normals = part.Normals, triangles = part.Triangles };
        }

        private static float DistanceTo(Vector3[] curve, Vector3 place)
        {
            float nearest = float.MaxValue;
            for (int k = 0; k <= 400; k++)
            {
                nearest = Math.Min(nearest, (Stalk.Bezier(curve, k / 400f) - place).magnitude);
            }

            return nearest;
        }
    }
}
