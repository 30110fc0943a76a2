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
            SurfaceMesh body = species.Body.CreateSurface(k_Millimetres);
            List<(List<int> Corners, Bounds Bounds)> pieces = BodyPieces.Of(body)
                .ConvertAll(piece => (Corners: piece, Bounds: BodyPieces.BoundsOf(body, piece)));
            foreach (WingDefinition wing in species.Wings)
            {
                SurfaceMesh surface = wing.CreateSurface(WingSide.Right, k_Millimetres);
                Vector3 hinge = wing.HingeOn(WingSide.Right, k_Millimetres);
                int step = Math.Max(1, surface.VertexCount / 150);
                for (int vertex = 0; vertex < surface.VertexCount; vertex += step)
                {
                    Vector3 place = surface.positions[vertex] + hinge;
                    foreach ((List<int> piece, Bounds _) in pieces.FindAll(piece => piece.Bounds.Contains(place)))
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
            SurfaceMesh body = species.Body.CreateSurface(k_Millimetres);
            foreach (WingDefinition wing in species.Wings)
            {
                Vector3 hinge = wing.HingeOn(WingSide.Right, k_Millimetres);
                float length = k_Millimetres * (float)wing.Outline.Length;
                float front = hinge.z + length * (float)wing.Outline.LeadingAt(0);
                float rear = hinge.z + length * (float)wing.Outline.TrailingAt(0);
                for (int k = 0; k <= 10; k++)
                {
                    var root = new Vector3(hinge.x, hinge.y, Mathf.Lerp(rear, front, k / 10f));
                    Assert.That(DistanceToSkin(body, root), Is.LessThan(0.03f * hinge.x + 0.03f), $"{wing.Name}, {k} tenths of the root");
                }
            }
        }

        [Test]
        public void TheSeat_PushesTheSkinInAndPullsItOut_AndLeavesTheRestAlone()
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
            Vector3 hinge = k_Millimetres * wing.Hinge;
            var middle = new Vector3(0f, hinge.y, hinge.z - 0.6f);
            foreach (float width in new[] { 0.8f, 1f, 1.2f })
            {
                BodyPart ball = Ellipsoid.Around(middle, new Vector3(width * hinge.x, 8f, 8f), 40, 40);
                BodyPart pressed = wing.CreateSeat().Press(ball);
                for (int vertex = 0; vertex < ball.Positions.Length; vertex++)
                {
                    Vector3 before = ball.Positions[vertex];
                    Vector3 after = pressed.Positions[vertex];
                    float away = (before - new Vector3(before.x, hinge.y, middle.z)).magnitude;
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
            float nearest = float.MaxValue;
            for (int corner = 0; corner < body.triangles.Length; corner += 3)
            {
                Vector3 a = body.positions[body.triangles[corner]];
                Vector3 b = body.positions[body.triangles[corner + 1]];
                Vector3 c = body.positions[body.triangles[corner + 2]];
                for (int i = 0; i <= 8; i++)
                {
                    for (int j = 0; i + j <= 8; j++)
                    {
                        nearest = Math.Min(nearest, ((i * a + j * b + (8 - i - j) * c) / 8f - point).sqrMagnitude);
                    }
                }
            }

            return (float)Math.Sqrt(nearest);
        }
    }
}
