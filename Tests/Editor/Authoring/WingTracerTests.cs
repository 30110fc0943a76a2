using System;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class WingTracerTests
    {
        /// <summary>Pixels of a picture's side.</summary>
        private const float k_Side = 240f;

        [TestCase(false, 0f, Explicit = true, Category = "Long")]
        [TestCase(false, 25f)]
        [TestCase(true, 0f)]
        [TestCase(true, 25f, Explicit = true, Category = "Long")]
        public void Mesh_HasTheHingeAtItsOrigin_TheLeadingEdgeAhead_AndTheSideOfThePicture(bool isLeft, float degrees)
        {
            WingTrace trace = Trace(DrawnWing.Monarch(), isLeft, degrees);

            float side = isLeft ? -1f : 1f, reach = 0f;
            foreach (Vector3 position in trace.Surface.positions)
                reach = Math.Max(reach, side * position.x);
            Assert.That(reach, Is.EqualTo(2f).Within(0.01), "the wing's length");
            Assert.That(trace.Skeleton.Hinge.magnitude, Is.LessThan(1e-4));
            Assert.That(side * trace.Skeleton.SpanAxis.x, Is.EqualTo(1f).Within(1e-3));
            Assert.That(trace.Skeleton.GetJoint(0, 2).z, Is.GreaterThan(trace.Skeleton.GetJoint(4, 2).z + 0.2f));
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void Mesh_LiesFlatAndFacesUp()
        {
            SurfaceMesh mesh = Trace(DrawnWing.Tailed()).Surface;

            for (int k = 0; k < mesh.triangles.Length; k += 3)
            {
                Vector3 a = mesh.positions[mesh.triangles[k]], b = mesh.positions[mesh.triangles[k + 1]],
                    c = mesh.positions[mesh.triangles[k + 2]];
                Assert.That(Vector3.Cross(b - a, c - a).y, Is.GreaterThan(0f));
            }

            Assert.That(Array.TrueForAll(mesh.positions, position => position.y == 0f));
            Assert.That(mesh.normals, Is.All.EqualTo(Vector3.up));
        }

        [Test]
        public void TextureCoordinates_AreThoseOfThePicture()
        {
            WingTrace trace = Trace(DrawnWing.Fan(), true, 30f);

            for (int k = 0; k < trace.Surface.VertexCount; k++)
            {
                Vector2 place = trace.Placement.ToPicture(trace.Surface.positions[k]), uv = trace.Surface.uvs[k];
                Assert.That(uv.x, Is.EqualTo(place.x / k_Side).Within(1e-4));
                Assert.That(uv.y, Is.EqualTo(1f - place.y / k_Side).Within(1e-4));
            }
        }

        [TestCase(50)]
        [TestCase(333, Explicit = true, Category = "Long")]
        [TestCase(5000)]
        public void Mesh_HasTheTrianglesAskedFor(int triangles)
        {
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.triangles = triangles;

            WingTrace trace = WingTracer.Trace(DrawnWing.Scalloped().In(300).Draw(DrawnKind.Silhouette).ToPicture(), settings);

            Assert.That(trace.Surface.TriangleCount, Is.EqualTo(triangles));
        }

        [Test]
        public void HingeThatIsGiven_IsTheMeshsOrigin()
        {
            WingPlace place = DrawnWing.Fan().In(400);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.hinge = place.At(Vector2.zero);

            WingTrace trace = WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);

            Assert.That((trace.Placement.ToPicture(Vector3.zero) - settings.hinge.Value).magnitude, Is.LessThan(0.5f));
            Assert.That(trace.Warnings, Has.None.Contains("hinge"));
        }

        [TestCase(false, 0f, Explicit = true, Category = "Long")]
        [TestCase(false, 25f)]
        [TestCase(false, -20f, Explicit = true, Category = "Long")]
        [TestCase(true, 0f, Explicit = true, Category = "Long")]
        [TestCase(true, 25f, Explicit = true, Category = "Long")]
        [TestCase(true, -20f)]
        public void HingeThatIsGuessed_LiesAtTheBase_NotAtThePointOfATailOrOfACleftTip(bool isTailed, float degrees)
        {
            DrawnWing wing = isTailed ? DrawnWing.LongTailed() : DrawnWing.Cleft();
            WingPlace place = wing.In(300, degrees, degrees > 0f);

            WingTrace trace = WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), WingTracingSettings.Default);

            Vector2 hinge = trace.Placement.ToPicture(trace.Skeleton.Hinge);
            Assert.That((hinge - place.At(Vector2.zero)).magnitude, Is.LessThan(0.1f * place.Length));
            Assert.That(trace.Warnings, Has.Some.Contains("hinge is a guess"));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void FaintEdge_IsSaidAndLowersTheConfidence()
        {
            WingPlace place = DrawnWing.Monarch().In(300);
            Color32 white = new Color32(255, 255, 255, 255), brown = new Color32(122, 85, 51, 255);
            var plain = new DrawnPicture(300, 300, white);
            DrawnPicture spotlight = new DrawnPicture(300, 300, white)
                .Shade((x, y) => -136f * Math.Min(1f, 2f * new Vector2(x - 0.5f, y - 0.5f).magnitude));

            WingTrace clear = WingTracer.Trace(plain.Fill(place.Outline, brown).ToPicture(), WingTracingSettings.Default);
            WingTrace faint = WingTracer.Trace(spotlight.Fill(place.Outline, brown).ToPicture(), WingTracingSettings.Default);

            Assert.That(clear.Warnings, Has.None.Contains("faint"));
            string said = faint.Warnings.First(warning => warning.Contains("faint"));
            Match share = Regex.Match(said, @" faint on (\d+) % of");
            Assert.That(share.Success, Is.True, said);
            Assert.That(int.Parse(share.Groups[1].Value), Is.InRange(10, 90), said);
            Assert.That(faint.Confidence, Is.LessThan(0.8f * clear.Confidence));
        }

        [Test]
        public void ClearEdge_IsNotCalledFaint([Values(DrawnKind.Silhouette, DrawnKind.Compressed)] DrawnKind kind) => AssertClear(kind);

        [Test]
        [Explicit]
        [Category("Long")]
        public void ClearEdgeOfAnyPicture_IsNotCalledFaint([Values] DrawnKind kind) => AssertClear(kind);

        private static void AssertClear(DrawnKind kind)
        {
            WingTrace trace = WingTracer.Trace(DrawnWing.Tailed().In(200).Draw(kind).ToPicture(), WingTracingSettings.Default);

            Assert.That(trace.Warnings, Has.None.Contains("faint"));
        }

        [Test]
        public void LeadingEdgeBelow_TurnsTheWingOver()
        {
            WingPlace place = DrawnWing.Monarch().In(400);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.forward = new Vector2(0f, 1f);
            settings.hinge = place.At(Vector2.zero);

            WingTrace trace = WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);

            Assert.That(trace.Skeleton.SpanAxis.x, Is.LessThan(-0.99f), "upside down, it is a left wing");
            Vector2 first = trace.Placement.ToPicture(trace.Skeleton.GetJoint(0, 2)),
                last = trace.Placement.ToPicture(trace.Skeleton.GetJoint(4, 2));
            Assert.That(first.y, Is.GreaterThan(last.y), "the first chain lies lower in the picture");
        }

        [Test]
        public void WingThatRunsOutOfThePicture_TurnsThere()
        {
            WingPlace place = DrawnWing.Scalloped().In(400, 0f, false, 0.9f);
            var picture = new DrawnPicture(400, 400, new Color32(255, 255, 255, 255));
            Vector2[] moved = Array.ConvertAll(place.Outline, point => point - new Vector2(60f, 0f));

            WingTrace trace = WingTracer.Trace(picture.Fill(moved, new Color32(0, 0, 0, 255)).ToPicture(), WingTracingSettings.Default);

            Assert.That(trace.Placement.ToPicture(trace.Skeleton.Hinge).x, Is.LessThan(3f));
            Assert.That(trace.Warnings, Has.Some.Contains("edge"));
        }

        // Cut by one side of the picture, or round a corner: the mean of the pixels there.
        [TestCase(0f, 60f, 0.5f, 81f)]
        [TestCase(0f, 120f, 0.5f, 141f)]
        [TestCase(-170f, 60f, 199.5f, 81f)]
        public void AHingeAtTheCut_IsTheMiddleOfIt(float right, float up, float x, float y)
        {
            var picture = new DrawnPicture(200, 200, new Color32(255, 255, 255, 255));
            float from = right < 0f ? 60f : -20f, to = right < 0f ? 220f : 140f;
            picture.Fill(new[] { new Vector2(from, up), new Vector2(to, up), new Vector2(to, up + 42f), new Vector2(from, up + 42f) },
                new Color32(0, 0, 0, 255));

            WingTrace trace = WingTracer.Trace(picture.ToPicture(), WingTracingSettings.Default);

            Vector2 hinge = trace.Placement.ToPicture(trace.Skeleton.Hinge);
            Assert.That(hinge.x, Is.EqualTo(x).Within(0.3f));
            Assert.That(hinge.y, Is.EqualTo(y).Within(0.3f));
        }

        [Test]
        public void MeshAndSkeleton_MakeARig()
        {
            WingTrace trace = Trace(DrawnWing.Tailed());

            var rig = WingRig.Bake(trace.Skeleton, trace.Surface, WingRigSettings.Default);

            Assert.That(rig.JointCount, Is.EqualTo(25));
            rig.Release();
        }

        [Test]
        public void SamePicture_GivesTheSameSkeleton()
        {
            WingPicture picture = new DrawnVeinPicture(DrawnWing.Monarch(), 200, 6, VeinLook.Photo).Picture.ToPicture();

            string one = SkeletonJson.Write(WingTracer.Trace(picture, WingTracingSettings.Default).Skeleton);

            Assert.That(SkeletonJson.Write(WingTracer.Trace(picture, WingTracingSettings.Default).Skeleton), Is.EqualTo(one));
        }

        // A line within a hundredth of the longer side from the border is no wing around the wing.
        [TestCase(600, 150)]
        [TestCase(150, 600)]
        public void AFrameOfALongPicture_IsIgnored(int width, int height)
        {
            var picture = new DrawnPicture(width, height, new Color32(255, 255, 255, 255));
            Vector2[] ellipse = Array.ConvertAll(new int[60], _ => Vector2.zero);
            for (int k = 0; k < ellipse.Length; k++)
            {
                float turn = 2f * Mathf.PI * k / ellipse.Length;
                ellipse[k] = new Vector2(0.5f * width + 0.36f * width * Mathf.Cos(turn), 0.5f * height + 0.36f * height * Mathf.Sin(turn));
            }

            picture.Fill(ellipse, new Color32(0, 0, 0, 255));
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.hinge = ellipse[width > height ? 30 : 45];
            settings.forward = width > height ? new Vector2(0f, -1f) : new Vector2(1f, 0f);
            WingTrace plain = WingTracer.Trace(picture.ToPicture(), settings);
            foreach (Rect side in new[]
            {
                new Rect(4f, 4f, width - 8f, 2f), new Rect(4f, height - 6f, width - 8f, 2f), new Rect(4f, 4f, 2f, height - 8f),
                new Rect(width - 6f, 4f, 2f, height - 8f),
            })
            {
                picture.Fill(new[] { side.min, new Vector2(side.xMax, side.yMin), side.max, new Vector2(side.xMin, side.yMax) },
                    new Color32(0, 0, 0, 255));
            }

            WingTrace framed = WingTracer.Trace(picture.ToPicture(), settings);
            Assert.That(framed.Surface.positions.Length, Is.EqualTo(plain.Surface.positions.Length).Within(20).Percent);
            for (int joint = 0; joint < 5; joint++)
            {
                Assert.That(Vector3.Distance(framed.Skeleton.GetJoint(2, joint), plain.Skeleton.GetJoint(2, joint)),
                    Is.LessThan(0.02f * plain.Skeleton.GetJoint(2, 4).magnitude));
            }
        }

        private static WingTrace Trace(DrawnWing wing, bool isLeft = false, float degrees = 0f)
        {
            WingPlace place = wing.In((int)k_Side, degrees, isLeft);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.length = 2f;
            settings.hinge = place.At(Vector2.zero);
            return WingTracer.Trace(place.Draw(DrawnKind.Silhouette).ToPicture(), settings);
        }
    }
}
