using System.Collections.Generic;
using System.Linq;
using Alate.Cli.Pictures;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>The painter and its paths.</summary>
    public sealed class PictureTests
    {
        private static readonly PaintedShape s_Red = new PaintedShape(0xff0000, false, false);

        private static readonly PaintedShape s_Blue = new PaintedShape(0x0000ff, false, false);

        [Test]
        public void FartherTriangle_IsPaintedFirst()
        {
            var painter = new Painter(20f, 20f, 1f);
            Add(painter, s_Red, 0, 0f, 1f);
            Add(painter, s_Blue, 3, 0f, 2f);

            Assert.That(Layers(painter).Select(layer => layer.Shape), Is.EqualTo(new[] { s_Blue, s_Red }));
        }

        [Test]
        public void PiecesApart_ShareALayer_WhateverLiesBetweenThemInDepth()
        {
            var painter = new Painter(60f, 20f, 1f);
            Add(painter, s_Red, 0, 0f, 3f);
            Add(painter, s_Blue, 3, 20f, 2f);
            Add(painter, s_Red, 6, 40f, 1f);

            List<PaintedLayer> layers = Layers(painter);

            Assert.That(layers, Has.Count.EqualTo(2));
            Assert.That(layers[0].Vertices, Has.Count.EqualTo(2));
        }

        [Test]
        public void PieceOverAnother_IsNotPaintedBeforeIt()
        {
            var painter = new Painter(20f, 20f, 1f);
            Add(painter, s_Red, 0, 0f, 3f);
            Add(painter, s_Blue, 3, 0f, 2f);
            Add(painter, s_Red, 6, 0f, 1f);

            Assert.That(Layers(painter).Select(layer => layer.Shape), Is.EqualTo(new[] { s_Red, s_Blue, s_Red }));
        }

        [Test]
        public void OutlineOfASquareOfTwoTriangles_HasFourCorners()
        {
            List<List<int>> outlines = Alate.Cli.Pictures.OutlineTracer.Outlines(new List<int3> { new int3(0, 1, 2), new int3(0, 2, 3) });

            Assert.That(outlines, Has.Count.EqualTo(1));
            Assert.That(outlines[0], Has.Count.EqualTo(5));
            Assert.That(outlines[0].Distinct(), Is.EquivalentTo(new[] { 0, 1, 2, 3 }));
        }

        [Test]
        public void OutlinesAroundAHole_AreTwo()
        {
            var triangles = new List<int3>();
            for (int k = 0; k < 4; k++)
            {
                int next = (k + 1) % 4;
                triangles.Add(new int3(k, next, 4 + k));
                triangles.Add(new int3(next, 4 + next, 4 + k));
            }

            Assert.That(Alate.Cli.Pictures.OutlineTracer.Outlines(triangles), Has.Count.EqualTo(2));
        }

        [Test]
        public void LinesInARow_AreOneStroke_WhereverTheyBegin()
        {
            var lines = new List<int3> { new int3(2, 3, -1), new int3(1, 2, -1), new int3(3, 4, -1) };

            List<List<int>> strokes = Alate.Cli.Pictures.OutlineTracer.Strokes(lines);

            Assert.That(strokes, Has.Count.EqualTo(1));
            Assert.That(strokes[0], Is.EqualTo(new[] { 1, 2, 3, 4 }));
        }

        [Test]
        public void Path_IsWrittenInRelativeSteps_WithoutPointsOnAStraightLine()
        {
            float3[] places = new[] { new float3(1f, 1f, 0f), new float3(2f, 1f, 0f), new float3(3f, 1f, 0f), new float3(1f, 0f, 0f) };
            var path = new SvgPath(5f);

            path.Add(new List<int> { 0, 1, 2, 3, 0 }, places, close: true);

            Assert.That(path.ToString(), Is.EqualTo("m5 5 10 0-10-5z"));
        }

        [Test]
        public void ThinnedPath_StaysWithinItsSlack_AndKeepsItsCorners()
        {
            var points = new List<int2> { new(0, 0), new(50, 1), new(100, 0), new(101, 60), new(100, 100), new(0, 100), new(1, 40) };

            PathThinning.Thin(points, isClosed: true, slack: 2f);

            Assert.That(points, Is.EqualTo(new[] { new int2(0, 0), new int2(100, 0), new int2(100, 100), new int2(0, 100) }));
        }

        [Test]
        public void Palette_KeepsTheMainColours_AndSaysWhichMostHave()
        {
            var orange = new float4(0.8f, 0.3f, 0f, 1f);
            var black = new float4(0f, 0f, 0f, 1f);
            float4[] colours = Enumerable.Range(0, 30).Select(k => k % 3 == 0 ? black : orange + new float4(0f, 0.002f * k, 0f, 0f)).ToArray();

            float4 ground = Palette.Reduce(colours, 3, 0.2f);

            Assert.That(colours.Distinct().Count(), Is.EqualTo(2), string.Join("; ", colours.Distinct()));
            Assert.That(math.length(ground - orange), Is.LessThan(0.1f));
            Assert.That(math.length(colours[0] - black), Is.LessThan(0.1f));
        }

        [Test]
        public void WhatLiesOnATriangle_IsPaintedRightAfterIt()
        {
            var painter = new Painter(20f, 20f, 1f);
            // One plane that leads away: the small triangle at its far end is farther than the large one in the mean.
            painter.AddTriangle(s_Red, new int3(0, 1, 2), new float3(1f, 1f, 1f), new float3(15f, 1f, 15f), new float3(1f, 15f, 1f));
            painter.AddTriangle(s_Blue, new int3(3, 4, 5), new float3(9f, 2f, 9f), new float3(11f, 2f, 11f), new float3(9f, 4f, 9f), above: 17f / 3f);

            Assert.That(Layers(painter).Select(layer => layer.Shape), Is.EqualTo(new[] { s_Red, s_Blue }));
        }

        [Test]
        public void RefinedMesh_KeepsItsAreaAndItsVertices()
        {
            var sheet = new Sheet(3, 2);
            var fine = new FineTriangles(sheet.rest.Length, sheet.triangles, 150);

            float3[] places = fine.Refine(sheet.rest);

            Assert.That(places.Take(sheet.rest.Length), Is.EqualTo(sheet.rest));
            Assert.That(fine.Triangles, Has.Count.EqualTo(12 * 16));
            float doubled = fine.Triangles.Sum(t => math.length(math.cross(places[t.y] - places[t.x], places[t.z] - places[t.x])));
            Assert.That(doubled, Is.EqualTo(2f * Sheet.Chord).Within(1e-5f));
            Assert.That(places.Distinct().Count(), Is.EqualTo(places.Length), "neighbours share the middles of their edges");
        }

        [Test]
        public void WhatIsHiddenBehindSolidThings_IsLeftOut()
        {
            var painter = new Painter(20f, 20f, 1f);
            painter.AddTriangle(s_Red, new int3(0, 1, 2), new float3(3f, 3f, 2f), new float3(4f, 3f, 2f), new float3(3f, 4f, 2f));
            Add(painter, s_Blue, 3, 0f, 1f);

            Assert.That(Layers(painter).Select(layer => layer.Shape), Is.EqualTo(new[] { s_Blue }));
        }

        [Test]
        public void ThroughGlass_OneSeesWhatIsBehind_AndTheGlassIsOneSheet()
        {
            var glass = new Glass(1, 40);
            var painter = new Painter(20f, 20f, 1f);
            painter.AddTriangle(s_Red, new int3(0, 1, 2), new float3(4f, 4f, 2f), new float3(6f, 4f, 2f), new float3(4f, 6f, 2f));
            Add(painter, new PaintedShape(0x00ff00, false, false, glass), 3, 0f, 1.5f);
            Add(painter, new PaintedShape(0x0000ff, false, false, glass), 6, 0f, 1f);

            List<PaintedSheet> sheets = painter.Sheets();

            Assert.That(sheets.Select(sheet => sheet.Glass), Is.EqualTo(new[] { default, glass }));
            Assert.That(sheets[1].Layers, Has.Count.EqualTo(2));
        }

        [TestCase(1f, 0)]
        [TestCase(0.97f, 0)]
        [TestCase(0.58f, 40)]
        [TestCase(0f, 90)]
        public void Opacity_ComesInSteps_AndNothingIsInvisible(float opacity, int percent)
        {
            Assert.That(Glass.Of(3, opacity, 10), Is.EqualTo(percent == 0 ? default : new Glass(3, percent)));
        }

        [TestCase("front-left", -1, -1)]
        [TestCase("front", -1, 0)]
        [TestCase("side", 0, -1)]
        [TestCase("top", 1, 0)]
        [TestCase("back", 1, 0)]
        public void FromEachSide_RightAndAheadLieWhereOneSeesThem(string view, int right, int ahead)
        {
            var camera = new PictureCamera(PictureView.ByName[view], 5f);

            Assert.That(math.length(camera.Project(float3.zero).xy), Is.EqualTo(0f).Within(1e-6f));
            Assert.That(camera.Project(new float3(0.1f, 0f, 0f)).x, Signed(right));
            Assert.That(camera.Project(new float3(0f, 0f, 0.1f)).x, Signed(ahead));
            Assert.That(camera.Project(new float3(0f, 0.1f, 0f)).y, Is.LessThan(view == "top" ? 1e-6f : -0.05f), "up is up");
        }

        private static IResolveConstraint Signed(int sign) =>
            sign == 0 ? Is.EqualTo(0f).Within(1e-6f) : sign > 0 ? Is.GreaterThan(0.01f) : (IResolveConstraint)Is.LessThan(-0.01f);

        private static List<PaintedLayer> Layers(Painter painter) => painter.Sheets().SelectMany(sheet => sheet.Layers).ToList();

        private static void Add(Painter painter, PaintedShape shape, int vertex, float x, float depth) => painter.AddTriangle(
            shape,
            new int3(vertex, vertex + 1, vertex + 2),
            new float3(x + 1f, 1f, depth),
            new float3(x + 11f, 1f, depth),
            new float3(x + 1f, 11f, depth));
    }
}
