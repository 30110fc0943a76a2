using System;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class HingeSeatTests
    {
        private const float k_Millimetres = 1000f;

        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [TestCaseSource(nameof(All))]
        public void AWingAtRest_PassesThroughNoPartOfTheBody(InsectDefinition species)
        {
            var body = species.Body.CreateSurface(k_Millimetres);
            var pieces = BodyPieces.Of(body).ConvertAll(piece => (Corners: piece, Bounds: BodyPieces.BoundsOf(body, piece)));
            foreach (var wing in species.Wings)
            {
                var surface = wing.CreateSurface(WingSide.Right, k_Millimetres);
                var hinge = wing.HingeOn(WingSide.Right, k_Millimetres);
                var step = Math.Max(1, surface.VertexCount / 150);
                for (var vertex = 0; vertex < surface.VertexCount; vertex += step)
                {
                    var place = surface.positions[vertex] + hinge;
                    foreach (var (piece, _) in pieces.FindAll(piece => piece.Bounds.Contains(place)))
                    {
                        Assert.That(
                            BodyPieces.Winding(body, piece, place), Is.LessThan(0.5),
                            $"{wing.Name} at {place}, {piece.Count} triangles at {body.positions[body.triangles[piece[0]]]}");
                    }
                }
            }
        }

        [TestCaseSource(nameof(All))]
        public void TheSkin_IsFlatWhereTheRootOfAWingLies(InsectDefinition species)
        {
            var body = species.Body.CreateSurface(k_Millimetres);
            foreach (var wing in species.Wings)
            {
                var hinge = wing.HingeOn(WingSide.Right, k_Millimetres);
                var length = k_Millimetres * (float)wing.Outline.Length;
                var front = hinge.z + length * (float)wing.Outline.LeadingAt(0);
                var rear = hinge.z + length * (float)wing.Outline.TrailingAt(0);
                for (var k = 0; k <= 10; k++)
                {
                    var root = new Vector3(hinge.x, hinge.y, Mathf.Lerp(rear, front, k / 10f));
                    Assert.That(DistanceToSkin(body, root), Is.LessThan(0.03f * hinge.x + 0.03f), $"{wing.Name}, {k} tenths of the root");
                }
            }
        }

        [Test]
        public void TheSeat_PushesTheSkinInAndPullsItOut_AndLeavesTheRestAlone()
        {
            var wing = InsectCatalogue.Find("monarch").Wings[0];
            var hinge = k_Millimetres * wing.Hinge;
            var middle = new Vector3(0f, hinge.y, hinge.z - 0.6f);
            foreach (var width in new[] { 0.8f, 1f, 1.2f })
            {
                var ball = Ellipsoid.Around(middle, new Vector3(width * hinge.x, 8f, 8f), 40, 40);
                var pressed = new HingeSeat(wing).Press(ball);
                for (var vertex = 0; vertex < ball.Positions.Length; vertex++)
                {
                    var before = ball.Positions[vertex];
                    var after = pressed.Positions[vertex];
                    var away = (before - new Vector3(before.x, hinge.y, middle.z)).magnitude;
                    Assert.That(after.y == before.y && after.z == before.z);
                    if (away < 0.15f)
                    {
                        Assert.That(Math.Abs(after.x), Is.EqualTo(before.x == 0f ? 0f : hinge.x).Within(0.01f * hinge.x));
                    }
                    else if (away > 3f)
                    {
                        Assert.That(after.x, Is.EqualTo(before.x));
                    }
                }
            }
        }

        // To the nearest triangle, measured at seven points of each: the triangles near a hinge are small.
        private static float DistanceToSkin(SurfaceMesh body, Vector3 point)
        {
            var nearest = float.MaxValue;
            for (var corner = 0; corner < body.triangles.Length; corner += 3)
            {
                var a = body.positions[body.triangles[corner]];
                var b = body.positions[body.triangles[corner + 1]];
                var c = body.positions[body.triangles[corner + 2]];
                for (var i = 0; i <= 8; i++)
                {
                    for (var j = 0; i + j <= 8; j++)
                    {
                        nearest = Math.Min(nearest, ((i * a + j * b + (8 - i - j) * c) / 8f - point).sqrMagnitude);
                    }
                }
            }

            return (float)Math.Sqrt(nearest);
        }
    }
}
