using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using Unity.Mathematics;
using Unity.StandIns;

namespace Alate.Tests.Cli
{
    /// <summary>The camera, and pages with labels.</summary>
    public sealed class PictureTests
    {
        [Test]
        public void EveryLetterOfTheLabels_HasAGlyphOfItsOwn()
        {
            const string k_Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:;-−–+=±×°%()/'…λ<>_&†";

            var shapes = k_Letters.Select(letter => string.Join(
                '|', Lettering.Strokes(letter.ToString(), 10f, false).Strokes.Select(stroke => string.Join(' ', stroke)))).ToList();
            Assert.That(shapes, Has.None.EqualTo(string.Join(' ', Lettering.Strokes("\u2603", 10f, false).Strokes[0])));
            Assert.That(shapes.GroupBy(shape => shape).Where(group => group.Count() > 1)
                .Select(group => string.Concat(group.Select(shape => k_Letters[shapes.IndexOf(shape)]))), Is.EquivalentTo(new[] { "II" }));
        }

        [Test]
        public void Text_EndsWhereItsAnchorSays([Values("start", "middle", "end")] string anchor)
        {
            var page = new PixelPage();
            page.Text(100f, 30f, 20f, "HHHH", anchor);
            float width = Lettering.Width("HHHH", 20f), left = 100f - (anchor == "end" ? width : anchor == "middle" ? 0.5f * width : 0f);
            var picture = PngFile.Read(page.Finish(200f, 40f, "H"));
            int[] inked = Enumerable.Range(0, picture.Pixels.Length).Where(k => picture.Pixels[k].r < 120)
                .Select(k => k % picture.Width).ToArray();

            Assert.That(inked.Min() / PixelPage.Fineness, Is.EqualTo(left).Within(1.5f));
            Assert.That(inked.Max() / PixelPage.Fineness, Is.EqualTo(left + width).Within(1.5f));
            Assert.That(page.Texts, Is.EqualTo(new[] { "HHHH" }));
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
    }
}
