using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Authoring;
using Alate.Cli;
using Alate.Editor.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    public sealed class SkeletonFromImageTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Picture_BecomesAMeshASkeletonAndAnOverlay()
        {
            string image = Image("wing.png", new DrawnVeinPicture(DrawnWing.Monarch(), 300, 6, VeinLook.Photo).Picture);

            int code = m_Run.Run("skeleton", "from-image", image, "--vein-widths", "--triangles", "777", "--chains", "6", "--joints", "4",
                "--out", m_Run.Out);

            Assert.That(code, Is.Zero, m_Run.Errors);
            Assert.That(m_Run.Output, Does.Contain("777 triangles").And.Contain("6 chains of 4 joints"));
            Assert.That(Read("wing.obj", ObjReader.Read).Triangles, Has.Length.EqualTo(3 * 777));
            WingSkeleton skeleton = Read("skeleton.json", reader => SkeletonJson.Read(reader.ReadToEnd()));
            Assert.That((skeleton.ChainCount, skeleton.JointsPerChain), Is.EqualTo((6, 4)));
            Assert.That(skeleton.Validate(), Is.Empty);
            Assert.That(skeleton.Chains.Count(chain => chain.veinWidths?.Length == 4), Is.GreaterThanOrEqualTo(3), "widths of veins");
            XElement svg = XDocument.Load(Path.Combine(m_Run.Out, "overlay.svg")).Root;
            XNamespace ns = svg.Name.Namespace;
            Assert.That(svg.Elements(ns + "image").Single().Attribute("width").Value, Is.EqualTo("300"));
            Assert.That(svg.Value, Does.Contain("300 × 300 pixels").And.Contain("777 triangles"));
            Assert.That(svg.Elements(ns + "polyline").Count(), Is.GreaterThan(6 + 3), "chains and veins");
            Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "skeleton.json", "wing.obj", "wing.mtl", "wing.png", "overlay.svg" }));
        }

        // Everything lies on the picture where the trace has it, in lines of a five hundredth of its longer side.
        [Test]
        public void TheOverlay_HasEachSideOfTheMeshOnce_TheOutline_AndEachJoint()
        {
            DrawnPicture drawn = new DrawnVeinPicture(DrawnWing.Monarch(), 300, 6, VeinLook.Photo).Picture;
            var file = PictureFile.Read(Image("wing.png", drawn));
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.triangles = 100;
            WingTrace trace = WingTracer.Trace(file.Picture, settings);
            var svg = XElement.Parse(TracePicture.Draw(file, trace));
            XNamespace ns = svg.Name.Namespace;
            double line = Math.Max(file.Picture.Width, file.Picture.Height) / 500.0;
            double[] Numbers(string text) => Regex.Matches(text,
                @"-?\d+(\.\d+)?").Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture)).ToArray();
            double Of(XElement element, string name) => double.Parse((string)element.Attribute(name), CultureInfo.InvariantCulture);
            void AssertNear(double[] told, System.Collections.Generic.IEnumerable<Vector2> places) =>
                Assert.That(told, Is.EqualTo(places.SelectMany(place => new double[] { place.x, place.y })).Within(0.051));

            Assert.That(Numbers((string)svg.Attribute("viewBox")),
                Is.EqualTo(new[] { 0.0, 0, file.Picture.Width, file.Picture.Height + 30 * line }).Within(0.01));
            XElement mesh = svg.Elements(ns + "path").Single();
            Vector2[] corners = Array.ConvertAll(trace.Surface.positions, trace.Placement.ToPicture);
            (int a, int b)[] sides = trace.Surface.triangles.Select((a, k) => (a, b: trace.Surface.triangles[k % 3 == 2 ? k - 2 : k + 1]))
                .GroupBy(side => (Math.Min(side.a, side.b), Math.Max(side.a, side.b))).Select(side => side.First()).ToArray();
            AssertNear(Numbers((string)mesh.Attribute("d")), sides.SelectMany(side => new[] { corners[side.a], corners[side.b] }));
            Assert.That(Of(mesh, "stroke-width"), Is.EqualTo(0.25 * line).Within(0.006));
            XElement outline = svg.Elements(ns + "polygon").Single();
            AssertNear(Numbers((string)outline.Attribute("points")), trace.Outline);
            Assert.That(Of(outline, "stroke-width"), Is.EqualTo(line).Within(0.006));
            XElement[] lines = svg.Elements(ns + "polyline").ToArray(), dots = svg.Elements(ns + "circle").ToArray();
            Assert.That(lines, Has.Length.EqualTo(trace.Veins.Count + trace.Skeleton.ChainCount));
            for (int k = 0; k < trace.Veins.Count; k++)
                AssertNear(Numbers((string)lines[k].Attribute("points")), trace.Veins[k]);
            Assert.That(trace.Veins.Count == 0 ? 1.2 * line : Of(lines[0], "stroke-width"), Is.EqualTo(1.2 * line).Within(0.006));
            Assert.That(dots, Has.Length.EqualTo(trace.Skeleton.ChainCount * trace.Skeleton.JointsPerChain + 1));
            for (int chain = 0; chain < trace.Skeleton.ChainCount; chain++)
            {
                Vector2[] joints = Array.ConvertAll(trace.Skeleton.Chains[chain].joints, trace.Placement.ToPicture);
                XElement own = lines[trace.Veins.Count + chain];
                AssertNear(Numbers((string)own.Attribute("points")), joints);
                Assert.That(((string)own.Attribute("stroke"), Of(own, "stroke-width")),
                    Is.EqualTo((trace.FollowsVein[chain] ? "#c026d3" : "#dc2626", Math.Round(1.5 * line, 2))));
                for (int k = 0; k < joints.Length; k++)
                {
                    XElement dot = dots[chain * joints.Length + k];
                    AssertNear([Of(dot, "cx"), Of(dot, "cy")], [joints[k]]);
                    Assert.That((Of(dot, "r"), (string)dot.Attribute("fill"), (string)dot.Attribute("stroke")),
                        Is.EqualTo((Math.Round(2.5 * line, 2), (string)own.Attribute("stroke"), "none")));
                }
            }

            AssertNear([Of(dots[^1], "cx"), Of(dots[^1], "cy")], [trace.Placement.ToPicture(trace.Skeleton.Hinge)]);
            Assert.That((Of(dots[^1], "r"), (string)dots[^1].Attribute("fill")), Is.EqualTo((Math.Round(6 * line, 2), "none")));
            XElement[] texts = svg.Elements(ns + "text").ToArray();
            Assert.That(texts[0].Value, Is.EqualTo("300 × 300 pixels, 100 triangles"));
            int on = trace.FollowsVein.Count(follows => follows);
            Assert.That(texts[1].Value, Is.EqualTo(
                $"outlineveins: {trace.Veins.Count}chains on veins: {on}other chains: {trace.Skeleton.ChainCount - on}"));
            Assert.That(texts.Select(text => Of(text, "y")), Is.EqualTo(new[] { 300 + 13 * line, 300 + 26 * line }).Within(0.006));
            Assert.That(texts.Select(text => (Of(text, "x"), Of(text, "font-size"))),
                Is.All.EqualTo((Math.Round(11 * line, 2), Math.Round(11 * line, 2))));
            XElement image = svg.Elements(ns + "image").Single();
            Assert.That(Convert.FromBase64String(((string)image.Attribute("href")).Split(',')[1]), Is.EqualTo(file.Bytes));
            Assert.That((Of(image, "width"), Of(image, "height")), Is.EqualTo(((double)file.Picture.Width, (double)file.Picture.Height)));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void MeshAndSkeleton_Fly()
        {
            string image = Image("wing.png", DrawnWing.Scalloped().In(300).Draw(DrawnKind.Silhouette)),
                flight = Path.Combine(m_Run.Folder, "flight");
            Assert.That(m_Run.Run("skeleton", "from-image", image, "--out", m_Run.Out), Is.Zero, m_Run.Errors);

            int code = m_Run.Run(
                "fly", "--mesh", Path.Combine(m_Run.Out, "wing.obj"), "--skeleton", Path.Combine(m_Run.Out, "skeleton.json"),
                "--species", "monarch",
                "--no-pictures", "--seconds", "0.3", "--out", flight);

            Assert.That(code, Is.Zero, m_Run.Errors);
            Assert.That(File.Exists(Path.Combine(flight, "wings.glb")));
        }

        [Test]
        public void Obj_HasTextureCoordinatesForEveryCorner()
        {
            string image = Image("wing.png", DrawnWing.Fan().In(200).Draw(DrawnKind.Transparent));

            m_Run.Run("skeleton", "from-image", image, "--triangles", "100", "--out", m_Run.Out);

            string[] lines = File.ReadAllLines(Path.Combine(m_Run.Out, "wing.obj"));
            Assert.That(lines.Count(line => line.StartsWith("vt ")), Is.EqualTo(lines.Count(line => line.StartsWith("v "))));
            foreach (string corner in lines.Where(line => line.StartsWith("f ")).SelectMany(line => line.Split(' ').Skip(1)))
                Assert.That(corner.Split('/')[0], Is.EqualTo(corner.Split('/')[1]));
        }

        [Test]
        public void LengthHingeAndLeadingEdge_AreAsSaid()
        {
            WingPlace place = DrawnWing.Monarch().In(300);
            Vector2 hinge = place.At(Vector2.zero);
            string image = Image("wing.png", place.Draw(DrawnKind.Silhouette));

            m_Run.Run(
                "skeleton", "from-image", image, "--length", "0.061", "--hinge", FormattableString.Invariant($"{hinge.x:F1},{hinge.y:F1}"),
                "--leading", "down", "--out", m_Run.Out);

            ObjMesh mesh = Read("wing.obj", ObjReader.Read);
            Assert.That(mesh.Positions.Min(p => p.x), Is.EqualTo(-0.061f).Within(1e-3f), "upside down, it is a left wing");
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void NumbersInOtherCultures_AreTheSame()
        {
            string image = Image("wing.png", DrawnWing.Fan().In(200).Draw(DrawnKind.Silhouette));
            m_Run.Run("skeleton", "from-image", image, "--out", m_Run.Out);
            string[] one = Contents();

            using (new CommaCulture())
                m_Run.Run("skeleton", "from-image", image, "--out", m_Run.Out);

            Assert.That(Contents(), Is.EqualTo(one));
        }

        [TestCase("", "empty")]
        [TestCase("this is no picture at all", "not a PNG")]
        public void FileThatIsNoPicture_IsRefused(string content, string said) => AssertRefused(m_Run.Write("wing.png", content), said);

        [TestCase("photo.gif", "GIF", "474946383961")]
        [TestCase("photo.bmp", "BMP", "424D3600000000000000")]
        [TestCase("photo.tif", "TIFF", "49492A0008000000")]
        [TestCase("photo.webp", "WebP", "524946460000000057454250")]
        public void PictureOfAnotherFormat_IsRefused_WithTheWayOut(string name, string format, string start)
        {
            string image = Image(name, Convert.FromHexString(start));

            AssertRefused(image, $"{name}': it is a {format}; convert it to PNG or JPEG.");
        }

        [Test]
        public void MissingFile_IsRefused() => AssertRefused(Path.Combine(m_Run.Folder, "none.png"), "no such file");

        [Test]
        public void Folder_IsRefused() => AssertRefused(m_Run.Folder, "folder");

        [TestCase(0.1)]
        [TestCase(0.5)]
        [TestCase(0.95)]
        [TestCase(0.9999)]
        public void TruncatedPicture_IsRefused(double share)
        {
            byte[] png = PngOf.Picture(DrawnWing.Fan().In(200).Draw(DrawnKind.Hard));

            AssertRefused(Image("wing.png", png.Take((int)(share * png.Length)).ToArray()), "cut off");
        }

        [Test]
        public void DamagedPicture_IsRefused()
        {
            byte[] png = PngOf.Picture(DrawnWing.Fan().In(200).Draw(DrawnKind.Hard));
            png[png.Length / 2] ^= 0x55;

            AssertRefused(Image("wing.png", png), "damaged");
        }

        [Test]
        public void PictureWithoutAWing_IsRefused() =>
            AssertRefused(Image("wing.png", new DrawnPicture(100, 100, new Color32(250, 250, 250, 255))), "No wing");

        [Test]
        public void PictureOfTwoWings_IsRefused()
        {
            Vector2[] wing = DrawnWing.Fan().In(300, 0f, false, 0.4f).Outline;
            var black = new Color32(0, 0, 0, 255);
            DrawnPicture picture = new DrawnPicture(300, 300, new Color32(250, 250, 250, 255))
                .Fill(Array.ConvertAll(wing, p => p - new Vector2(75f, 0f)), black)
                .Fill(Array.ConvertAll(wing, p => p + new Vector2(75f, 0f)), black);

            AssertRefused(Image("wing.png", picture), "2 wings");
        }

        [Test]
        public void TinyPicture_IsRefused() =>
            AssertRefused(Image("wing.png", new DrawnPicture(16, 16, new Color32(250, 250, 250, 255))), "too small");

        [TestCase("--chains", "2")]
        [TestCase("--joints", "17")]
        [TestCase("--triangles", "49")]
        [TestCase("--triangles", "many")]
        [TestCase("--hinge", "1")]
        [TestCase("--hinge", "1,2,3")]
        [TestCase("--hinge", "-1,5")]
        [TestCase("--hinge", "5,201")]
        [TestCase("--hinge", "nan,5")]
        [TestCase("--leading", "sideways")]
        [TestCase("--length", "0")]
        public void ValueOutOfItsRange_IsNamed(string option, string value)
        {
            string image = Image("wing.png", DrawnWing.Fan().In(200).Draw(DrawnKind.Silhouette));

            AssertRefused(image, option.TrimStart('-'), option, value);
        }

        [Test]
        public void Command_ExplainsItself()
        {
            int code = m_Run.Run("skeleton", "from-image", "--help");

            Assert.That(code, Is.Zero);
            Assert.That(m_Run.Output, Does.Contain("--hinge").And.Contain("overlay.svg").And.Contain("Exit code"));
        }

        private void AssertRefused(string image, string said, params string[] options)
        {
            string[] before = Directory.GetFileSystemEntries(m_Run.Folder);

            int code = m_Run.Run(new[] { "skeleton", "from-image", image, "--out", m_Run.Out }.Concat(options).ToArray());

            Assert.That(code, Is.EqualTo(2), m_Run.Errors);
            Assert.That(m_Run.Errors.Split('\n'), Has.Length.EqualTo(2), "one line: " + m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Contain(said).IgnoreCase);
            Assert.That(m_Run.Output, Is.Empty);
            Assert.That(Directory.GetFileSystemEntries(m_Run.Folder), Is.EquivalentTo(before), "nothing was written");
        }

        private string Image(string name, DrawnPicture picture) => Image(name, PngOf.Picture(picture));

        private string Image(string name, byte[] png)
        {
            string path = Path.Combine(m_Run.Folder, name);
            File.WriteAllBytes(path, png);
            return path;
        }

        private T Read<T>(string name, Func<TextReader, T> read)
        {
            using StreamReader reader = File.OpenText(Path.Combine(m_Run.Out, name));
            return read(reader);
        }

        private string[] Contents() =>
            Directory.GetFiles(m_Run.Out).OrderBy(file => file, StringComparer.Ordinal).Select(File.ReadAllText).ToArray();
    }
}
