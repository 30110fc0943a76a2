using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of rims, pointed ends, placements and settings of traced wings.</summary>
    public sealed class TracingLaws
    {
        [TestCase(12.3, 20.4, 9.7)]
        [TestCase(25.0, 25.0, 18.2)]
        public void TheRimOfADisc_RunsClockwiseAsSeen_OnItsCircle(double x, double y, double radius)
        {
            var field = new PixelPlane(50, 50);
            for (int k = 0; k < field.values.Length; k++)
                field.values[k] = (float)(radius - Math.Sqrt(Math.Pow(k % 50 + 0.5 - x, 2.0) + Math.Pow(k / 50 + 0.5 - y, 2.0)));
            List<PlanPoint> rim = ContourTracer.Longest(field);

            Assert.That(rim.Select(p => Math.Sqrt(Math.Pow(p.x - x, 2.0) + Math.Pow(p.z - y, 2.0))), Is.All.EqualTo(radius).Within(0.05));
            Assert.That(
                Polygon.Area(rim), Is.EqualTo(Math.PI * radius * radius).Within(0.01 * radius * radius), "clockwise where y points down");
        }

        [Test]
        public void ARim_IsTheLongest_PassesWhereTheFieldIsZero_AndEndsAtThePicturesEdge()
        {
            var field = new PixelPlane(20, 10);
            Array.Fill(field.values, -1f);
            field[2, 2] = 3f;
            for (int row = 3; row < 10; row++)
            {
                for (int column = 8; column < 14; column++)
                    field[column, row] = 3f;
            }

            List<PlanPoint> rim = ContourTracer.Longest(field);
            Assert.That((rim.Min(p => p.x), rim.Max(p => p.x)), Is.EqualTo((7.75, 14.25)), "a quarter of the way from −1 to 3");
            Assert.That(rim.Min(p => p.z), Is.EqualTo(2.75));
            Assert.That(rim.Max(p => p.z), Is.EqualTo(10.5).Within(1e-3), "the picture's edge, where ground begins at once");
        }

        [Test]
        public void PixelsThatTouchByACorner_HangTogether()
        {
            var field = new PixelPlane(12, 12);
            Array.Fill(field.values, -1f);
            for (int k = 0; k < 9; k++)
            {
                field[2 + k % 3, 2 + k / 3] = 1f;
                field[5 + k % 3, 5 + k / 3] = 1f;
            }

            List<PlanPoint> rim = ContourTracer.Longest(field);
            Assert.That((rim.Min(p => p.x), rim.Max(p => p.x)), Is.EqualTo((2.0, 8.0)));
        }

        [Test]
        public void ThePointedEnd_IsTheSameEnd_HoweverTheWingLies([Values] bool mirrored, [Values(0.0, 1.0, 2.5, 4.0)] double angle)
        {
            // A slice of a cake.
            PlanPoint[] slice = Enumerable.Range(-1, 62).Select(k =>
            {
                double t = 0.9 * (k / 60.0 - 0.5), x = k < 0 ? 0.0 : 4.0 * Math.Cos(t),
                    z = k < 0 ? 0.0 : (mirrored ? -4.0 : 4.0) * Math.Sin(t);
                return new PlanPoint(30.0 + Math.Cos(angle) * x - Math.Sin(angle) * z, -8.0 + Math.Sin(angle) * x + Math.Cos(angle) * z);
            }).ToArray();
            if (Polygon.Area(slice) < 0.0)
                Array.Reverse(slice);
            (PlanPoint place, double confidence) = PointedEnd.Of(slice);

            Assert.That(Math.Sqrt((place - new PlanPoint(30.0, -8.0)).LengthSquared), Is.LessThan(0.1));
            Assert.That(confidence, Is.EqualTo(0.95).Within(1e-6), "far more pointed");
        }

        [Test]
        public void EndsThatAreAlike_AreAGuess_AndATrianglesHingeLiesOppositeItsShortestSide()
        {
            PlanPoint[] lens = Enumerable.Range(0, 300)
                .Select(k => new PlanPoint(3.0 * Math.Cos(2.0 * Math.PI * k / 300.0), Math.Sin(2.0 * Math.PI * k / 300.0))).ToArray();
            Assert.That(PointedEnd.Of(lens).Confidence, Is.EqualTo(0.5).Within(0.02));
            foreach (double x in new[] { 3.4, 2.6 })
            {
                PlanPoint[] triangle = { new PlanPoint(0, 0), new PlanPoint(6, 0), new PlanPoint(x, 3) };
                (PlanPoint place, double confidence) = PointedEnd.Of(triangle);
                Assert.That((place.x, place.z), Is.EqualTo((x > 3.0 ? 0.0 : 6.0, 0.0)));
                Assert.That(confidence, Is.EqualTo(0.85));
            }
        }

        [Test]
        public void APlacement_TurnsScalesAndMoves_ThereAndBack()
        {
            var picture = new WingPicture(64, 48, new Color32[64 * 48]);
            var placement = new WingPlacement(picture, new PlanPoint(10.0, -20.0), new PlanPoint(0.6, 0.8), 0.05);
            Vector2 tip = placement.ToPicture(new Vector3(1f, 0f, 0f)), ahead = placement.ToPicture(new Vector3(0f, 0f, 1f));

            Assert.That(placement.UnitsPerPixel, Is.EqualTo(0.05f));
            Assert.That((placement.ToPicture(Vector3.zero) - new Vector2(10f, 20f)).magnitude, Is.LessThan(1e-5f));
            Assert.That((tip - new Vector2(22f, 4f)).magnitude, Is.LessThan(1e-5f), "20 pixels along the axis, y down");
            Assert.That((ahead - new Vector2(-6f, 8f)).magnitude, Is.LessThan(1e-5f));
            var place = new PlanPoint(33.0, -41.0);
            Assert.That((placement.ToPicture(placement.ToMesh(place)) - new Vector2(33f, 41f)).magnitude, Is.LessThan(1e-4f));
            Assert.That((placement.ToTexture(place) - new Vector2(33f / 64f, 1f - 41f / 48f)).magnitude, Is.LessThan(1e-6f));
            Assert.That(placement.ToTexture(new PlanPoint(-1.0, 1.0)), Is.EqualTo(new Vector2(0f, 1f)));
            Assert.That(placement.ToTexture(new PlanPoint(65.0, -49.0)), Is.EqualTo(new Vector2(1f, 0f)));
        }

        [TestCase(58f, false, Explicit = true, Category = "Long")]
        [TestCase(63f, true, Explicit = true, Category = "Long")]
        [TestCase(-58f, false, Explicit = true, Category = "Long")]
        [TestCase(-63f, true)]
        public void WhereTheWingStandsUpright_ItsShapeTellsTheLeadingEdge_AndElseTheUpperOneIt(float degrees, bool isByShape)
        {
            WingTracingSettings settings = WingTracingSettings.Default;
            WingPlace place = DrawnWing.Monarch().In(300, degrees);
            settings.hinge = place.At(Vector2.zero);
            WingTrace guessed = WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);
            Vector2 span = place.At(Vector2.right) - place.At(Vector2.zero);
            settings.forward = new Vector2(span.y, -span.x);
            WingTrace told = WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);

            Assert.That(guessed.Warnings.Any(warning => warning.Contains("points up or down")), Is.EqualTo(isByShape));
            Assert.That(guessed.Warnings.Any(warning => warning.Contains("the upper one in the picture")), Is.Not.EqualTo(isByShape));
            Assert.That(guessed.Confidence / told.Confidence, Is.EqualTo(isByShape ? 0.6f : 0.8f).Within(0.01f));
        }

        [Test]
        public void Settings_HoldTheirLimits_AndNothingBeyond()
        {
            var picture = new WingPicture(64, 48, new Color32[64 * 48]);
            void Check(WingTracingSettings settings, string problem)
            {
                if (problem == null)
                    Assert.That(() => settings.Check(picture), Throws.Nothing);
                else
                    Assert.That(() => settings.Check(picture), Throws.InstanceOf<ArgumentException>().With.Message.Contains(problem));
            }

            WingTracingSettings With(
                int chains = 5, int joints = 5, int triangles = 1000, float length = 1f, Vector2? hinge = null, Vector2? forward = null) =>
                new WingTracingSettings
                {
                    chains = chains,
                    jointsPerChain = joints,
                    triangles = triangles,
                    length = length,
                    hinge = hinge,
                    forward = forward,
                };
            Check(WingTracingSettings.Default, null);
            Check(With(3, 16, 50, 1e6f, new Vector2(64f, 48f), new Vector2(-1f, 0f)), null);
            Check(With(16, 3, 200000, 1e-6f, Vector2.zero), null);
            Check(With(2), "3 to 16 chains");
            Check(With(joints: 17), "3 to 16 joints");
            Check(With(triangles: 49), "50 to 200000 triangles");
            Check(With(triangles: 200001), "50 to 200000 triangles");
            Check(With(length: 0f), "above 0");
            Check(With(length: 1.1e6f), "at most a million");
            Check(With(length: float.NaN), "above 0");
            Check(With(hinge: new Vector2(64.1f, 5f)), "(64.1, 5) lies outside the picture, which is 64 × 48 pixels");
            Check(With(hinge: new Vector2(5f, -0.1f)), "outside the picture");
            Check(With(hinge: new Vector2(5f, 48.1f)), "outside the picture");
            Check(With(forward: Vector2.zero), "zero or not finite");
            Check(With(forward: new Vector2(float.NaN, 1f)), "zero or not finite");
            WingTracingSettings standard = WingTracingSettings.Default;
            Assert.That((standard.chains, standard.jointsPerChain, standard.triangles, standard.length, standard.veinWidths),
                Is.EqualTo((5, 5, 1000, 1f, false)));
        }

        [Test]
        public void Pictures_AreReadFrom32To16384PixelsASide()
        {
            Assert.That(() => WingPicture.FromGrey(32, 32, new byte[32 * 32]), Throws.Nothing);
            Assert.That(() => WingPicture.FromGrey(31, 32, new byte[31 * 32]),
                Throws.TypeOf<FormatException>().With.Message.Contains("31 × 32 pixels; it needs at least 32 × 32"));
            Assert.That(() => WingPicture.FromGrey(32, 31, new byte[31 * 32]), Throws.TypeOf<FormatException>());
            Assert.That(() => WingPicture.FromGrey(16384, 32, new byte[16384 * 32]), Throws.Nothing);
            Assert.That(() => WingPicture.FromGrey(16385, 32, new byte[16385 * 32]),
                Throws.TypeOf<FormatException>().With.Message.Contains("too large"));
            Assert.That(() => WingPicture.FromGrey(32, 33, new byte[32 * 32]),
                Throws.ArgumentException.With.Message.Contains("needs 1056 of them, not 1024"));
        }
    }
}
