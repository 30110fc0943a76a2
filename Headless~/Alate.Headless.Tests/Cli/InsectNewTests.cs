using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Editor.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary><c>insect new</c>: from pictures and a few numbers with their units to an insect that flies.</summary>
    public sealed class InsectNewTests
    {
        private static readonly Lazy<byte[]>
            s_Fore = new(() => PngOf.Picture(DrawnWing.Scalloped().In(200).Draw(DrawnKind.Silhouette))),
            s_Hind = new(() => CameraPicture.WithExif(CameraPicture.Of("base"), CameraPicture.Exif(3, true)));

        private CommandRun m_Run;
        private string m_Fore, m_Hind;

        [SetUp]
        public void Draw()
        {
            m_Run = new CommandRun();
            m_Fore = Path.Combine(m_Run.Folder, "front.png");
            m_Hind = Path.Combine(m_Run.Folder, "back.jpg");
            File.WriteAllBytes(m_Fore, s_Fore.Value);
            File.WriteAllBytes(m_Hind, s_Hind.Value);
        }

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void TwoPictures_BecomeAnInsectOfThatSize_WhichFlies_WithTheirTextures()
        {
            New("--wing", m_Fore, m_Hind, "--length", "5cm", "38mm", "--mass", "1.6g", "--frequency", "25Hz");

            Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[]
            {
                "out.insect.json", "fore.obj", "fore.mtl", "fore.png", "fore.json", "fore.svg", "hind.obj", "hind.mtl", "hind.png",
                "hind.json", "hind.svg",
            }));
            JsonNode file = ReadFile();
            Assert.That(((double)file["massMilligrams"], (double)file["beat"]["frequencyHertz"]), Is.EqualTo((1600.0, 25.0)));
            Assert.That((double)Wing(file, 0)["lengthMillimetres"], Is.EqualTo(50));
            AssertPointsBack();
            var traced = TracedWing.Of(m_Hind, Alate.Authoring.WingTracingSettings.Default);
            float toTip = WingFiles.FrameOf(traced.Trace.Skeleton, traced.Trace.Surface, m_Hind).length;
            traced.Trace.Skeleton.SpanAxis =
                Alate.Authoring.SkeletonJson.Read(File.ReadAllText(Path.Combine(m_Run.Out, "hind.json"))).SpanAxis;
            float across = WingFiles.FrameOf(traced.Trace.Skeleton, traced.Trace.Surface, m_Hind).length;
            Assert.That(across, Is.LessThan(0.95f * toTip));
            Assert.That((double)Wing(file, 1)["lengthMillimetres"], Is.EqualTo(38 * across / toTip).Within(0.011));
            string flight = Path.Combine(m_Run.Folder, "flight");
            Assert.That(m_Run.Run("fly", FilePath, "--pitch", "20", "--no-pictures", "--out", flight), Is.Zero, m_Run.Errors);
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(flight, "summary.json")));
            Assert.That((double)summary["frequency_hz"], Is.EqualTo(25).Within(1e-3));
            Assert.That((double)summary["edge_stretch_max_pct"], Is.InRange(0.1, 10));
            Assert.That((double)summary["edge_stretch_p99_pct"], Is.InRange(0.1, 4));
            Assert.That(summary["doubts"].AsArray(), Is.Empty, "sizes and masses fit one another");
            Assert.That(summary["inputs"].AsArray().Select(input => Path.GetFileName((string)input["file"])),
                Is.SupersetOf(new[] { "fore.png", "hind.png" }));
            var glb = new GlbFile(File.ReadAllBytes(Path.Combine(flight, "wings.glb")));
            Assert.That(glb.Root.GetProperty("images").GetArrayLength(), Is.GreaterThanOrEqualTo(2));
        }

        // Meshes of any size, far from the origin, of which one has a material with a picture.
        [Test]
        public void TwoMeshesAndABody_BecomeAnInsect_WithTheFilesAsTheyAre()
        {
            InsectDefinition fishfly = InsectCatalogue.Find("fishfly");
            string[] meshes = [.. fishfly.Wings.Select((wing, k) =>
            {
                SurfaceMesh surface = wing.CreateSurface(WingSide.Left);
                for (int vertex = 0; vertex < surface.positions.Length; vertex++)
                    surface.positions[vertex] = 300 * surface.positions[vertex] + new UnityEngine.Vector3(0, 2000, 70);
                return Obj($"wing{k}.obj", surface, k == 0 ? "wing.mtl" : null);
            })];
            m_Run.Write("wing.mtl", ObjMaterial.Write("wing", "front.png"));
            string body = Obj("thorax.obj", fishfly.Body.CreateSurface(1f), null);
            New("--wing", meshes[0], meshes[1], "--length", "3cm", "28mm", "--mass", "200mg", "--frequency", "20Hz", "--like", "fishfly",
                "--body", body, "--body-unit", "1cm");

            Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[]
            {
                "out.insect.json", "fore.obj", "fore.png", "fore.json", "fore.svg", "hind.obj", "hind.json", "hind.svg", "body.obj",
            }));
            foreach ((string given, string written) in new[] { (meshes[0], "fore.obj"), (meshes[1], "hind.obj"), (body, "body.obj") })
                Assert.That(File.ReadAllBytes(Path.Combine(m_Run.Out, written)), Is.EqualTo(File.ReadAllBytes(given)));
            JsonNode file = ReadFile();
            Assert.That((double)file["body"]["meshUnitMillimetres"], Is.EqualTo(10));
            Assert.That((double)Wing(file, 0)["lengthMillimetres"], Is.EqualTo(30));
            AssertPointsBack("fishfly");
            AssertInPlace(InsectFile.Read(FilePath).Body.CreateSurface(1f), fishfly.Body.CreateSurface(1f));
            string flight = Path.Combine(m_Run.Folder, "flight");
            Assert.That(m_Run.Run("fly", FilePath, "--no-pictures", "--out", flight), Is.Zero, m_Run.Errors);
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(flight, "summary.json")));
            Assert.That((double)summary["edge_stretch_max_pct"], Is.InRange(0.1, 10));
        }

        // Larger or smaller about the thorax, which stays where it is.
        private static void AssertInPlace(SurfaceMesh read, SurfaceMesh given)
        {
            Bounds told = Box(read), own = Box(given);
            float scale = told.size.z / own.size.z;
            Assert.That(Vector3.Distance(told.center, scale * own.center), Is.LessThan(1e-4f * told.size.magnitude));
            Assert.That(own.center.magnitude, Is.GreaterThan(0.01f * own.size.magnitude), "a body that lies about the thorax");
        }

        private static Bounds Box(SurfaceMesh surface)
        {
            var box = new Bounds(surface.positions[0], Vector3.zero);
            foreach (Vector3 place in surface.positions)
                box.Encapsulate(place);
            return box;
        }

        private string Obj(string name, SurfaceMesh surface, string library)
        {
            string path = Path.Combine(m_Run.Folder, name);
            using FileStream stream = File.Create(path);
            surface.uvs ??= new UnityEngine.Vector2[surface.positions.Length];
            ObjWriter.Write(surface, stream, library, "wing");
            return path;
        }

        // As that of the other: the middle of its area lies behind the hinge.
        private void AssertPointsBack(string like = "swallowtail")
        {
            InsectDefinition[] insects = [KnownSpecies.Find(FilePath), InsectCatalogue.Find(like)];
            WingDefinition[] wings = [.. insects.Select(insect => insect.Wings[1])];
            double[] angles = [.. wings.Select(Angle)];
            Assert.That(angles[0], Is.EqualTo(angles[1]).Within(0.1));
            Assert.That(angles[0], Is.InRange(-70, -15), "degrees; a wing that was found lies straight across");
        }

        // Of the middle of the area before the axis across the body, from the hinge.
        private static double Angle(WingDefinition wing)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            UnityEngine.Vector3 hinge = wing.CreateSkeleton(WingSide.Right).Hinge;
            double x = 0, z = 0;
            for (int k = 0; k < surface.triangles.Length; k += 3)
            {
                UnityEngine.Vector3[] at = [.. surface.triangles.Skip(k).Take(3).Select(corner => surface.positions[corner] - hinge)];
                UnityEngine.Vector3 one = at[1] - at[0], other = at[2] - at[0];
                double area = Math.Abs((double)one.x * other.z - (double)other.x * one.z);
                x += area * at.Sum(place => place.x);
                z += area * at.Sum(place => place.z);
            }

            return Math.Atan2(z, x) * 180 / Math.PI;
        }

        // Its leading edge is up in the picture, whichever way the tip points, so that a wing of the left is drawn as in a mirror.
        [TestCase(false)]
        [TestCase(true)]
        public void AWingOfEitherSide_TurnsBackwards_ByTheSameAngle(bool mirrored)
        {
            File.WriteAllBytes(m_Fore, PngOf.Picture(DrawnWing.Scalloped().In(200, 0f, mirrored).Draw(DrawnKind.Silhouette)));
            var wing = TracedWing.Of(m_Fore, Alate.Authoring.WingTracingSettings.Default);
            WingDefinition like = InsectCatalogue.Find("fishfly").Wings[1];
            WingFrame before = WingFiles.FrameOf(wing.Trace.Skeleton, wing.Trace.Surface, m_Fore);
            double was = WingTurn.Direction(wing.Trace.Surface, before);
            WingTurn.TurnLike(wing, like);
            WingFrame after = WingFiles.FrameOf(wing.Trace.Skeleton, wing.Trace.Surface, m_Fore);

            double now = WingTurn.Direction(wing.Trace.Surface, after);
            Assert.That(now * 180 / Math.PI, Is.EqualTo(Angle(like)).Within(0.1));
            Assert.That(was * 180 / Math.PI, Is.InRange(-15, 15), "it lay across");
            Assert.That(after.mirrored, Is.EqualTo(before.mirrored));
        }

        [Test]
        public void OnePicture_BecomesAWing_AndFreeFlightsSayWhatTheyNeed()
        {
            New("--wing", m_Hind, "--length", "50mm", "--mass", "1.6g", "--frequency", "25", "--name", "My moth");
            Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName), Does.Contain("my-moth.insect.json"));
            Assert.That((string)ReadFile("my-moth")["like"], Is.EqualTo("monarch"));
            Assert.That(m_Run.Run("fly", Path.Combine(m_Run.Out, "my-moth.insect.json"), "--free"), Is.EqualTo(2));
            Assert.That(m_Run.Errors, Does.Contain("has no trim table for these numbers: 'trim' says"));
        }

        /// <summary>A body of eight times the mass is twice as long: as dense; its wings weigh eight times as much.</summary>
        [TestCase("monarch")]
        [TestCase("dragonfly")]
        public void TheBody_IsThatOfTheCatalogue_AtTheMass(string like)
        {
            InsectDefinition known = InsectCatalogue.Find(like);
            double mass = 1e6 * known.Wings[0].CreatePreset().Size.insectMass;
            New("--wing", m_Hind, "--length", "50mm", "--mass", FormattableString.Invariant($"{8 * mass}mg"), "--frequency", "25", "--like",
                like);
            InsectDefinition made = KnownSpecies.Find(FilePath);

            Assert.That(made.Wings, Has.Count.EqualTo(1), "one picture is one kind of wing");
            for (int k = 0; k < known.FlightParts.Count; k++)
            {
                Assert.That(made.FlightParts[k].halfAxes.z, Is.EqualTo(2 * known.FlightParts[k].halfAxes.z).Within(0.1).Percent);
                Assert.That(made.FlightParts[k].centre.z, Is.EqualTo(2 * known.FlightParts[k].centre.z).Within(0.1).Percent);
            }

            Assert.That(made.Wings[0].CreatePreset().Size.wingMass,
                Is.EqualTo(8 * known.Wings[0].CreatePreset().Size.wingMass).Within(0.1).Percent);
            Assert.That((double)made.Wings[0].Hinge.x, Is.EqualTo(2 * known.Wings[0].Hinge.x).Within(0.1).Percent);
        }

        [Test]
        public void AHindWing_IsAsLongAsThatOfTheOther_WhereNobodySays()
        {
            New("--wing", m_Hind, m_Fore, "--length", "100mm", "--mass", "1.6g", "--frequency", "25", "--like", "dragonfly");
            Assert.That((double)Wing(ReadFile(), 1)["lengthMillimetres"], Is.EqualTo(97));
        }

        [TestCase("--length", "5cm", "50", "50000µm")]
        [TestCase("--mass", "1.6 g", "1600", "0.0016kg")]
        [TestCase("--frequency", "1500/min", "25", "157.07963267949rad/s")]
        [TestCase("--length", "50mm", "50", "0.05m", "5e-2m", "50 mm", "50000um", Explicit = true, Category = "Long")]
        [TestCase("--mass", "1600mg", "1600", "1.6g", "1600000µg", Explicit = true, Category = "Long")]
        [TestCase("--frequency", "25Hz", "25", "25", "25/s", "0.025kHz", Explicit = true, Category = "Long")]
        public void Units_AreAllTheSame(string option, string first, string value, params string[] others)
        {
            foreach (string typed in others.Prepend(first))
            {
                List<string> words = ["--wing", m_Hind, "--length", "50mm", "--mass", "1.6g", "--frequency", "25Hz"];
                words[words.IndexOf(option) + 1] = typed;
                New([.. words]);
                JsonNode file = ReadFile(), said = option switch
                {
                    "--length" => Wing(file, 0)["lengthMillimetres"],
                    "--mass" => file["massMilligrams"],
                    _ => file["beat"]["frequencyHertz"],
                };
                Assert.That(said.ToJsonString(), Is.EqualTo(value), typed);
            }
        }

        [TestCase("--length", "50", "--length 50 has no unit: is it 50mm or 50cm or 50m?")]
        [TestCase("--length", "mm", "--length takes a length with its unit, such as 25mm or 25cm or 25m, not 'mm'.")]
        [TestCase("--length", "50furlongs", "--length takes a length in mm, cm, m, µm, um, in; 'furlongs' is none of them.")]
        [TestCase("--length", "50MM", "'MM' is none of them.")]
        [TestCase("--length", "5m", "--length must lie between 0.5 and 1000 mm; 5m does not.")]
        [TestCase("--length", "NaNmm", "--length takes a length with its unit")]
        [TestCase("--length", "1e300m", "--length must lie between 0.5 and 1000 mm; 1e300m does not.")]
        [TestCase("--length", "1e25m", "--length must lie between 0.5 and 1000 mm; 1e25m does not.")]
        [TestCase("--length", null, "How long is the wing? --length, from hinge to tip with its unit, such as 50mm.")]
        [TestCase("--mass", "1.6", "--mass 1.6 has no unit: is it 1.6mg or 1.6g or 1.6kg?")]
        [TestCase("--mass", "-1g", "--mass must lie between 0.01 and 10000000 mg; -1g does not.")]
        [TestCase("--mass", null, "How heavy is the insect? --mass, with its unit, such as 1.6g.")]
        [TestCase("--frequency", "25mm", "--frequency takes a frequency in Hz, /s, /min, kHz, rad/s; 'mm' is none of them.")]
        [TestCase("--frequency", "2kHz", "--frequency must lie between 0.1 and 1000 Hz; 2kHz does not.")]
        [TestCase("--frequency", null, "How often does it beat? --frequency, such as 25Hz.")]
        [TestCase("--wing", null, "Which wing? --wing takes a picture or a mesh of it, or of the fore and of the hind wing.")]
        [TestCase("--wing", "none.png", "Cannot read 'none.png': there is no such file.")]
        [TestCase("--like", "wasp", "Unknown species 'wasp'.")]
        [TestCase("--body", "none.obj", "How long is a unit of the body's mesh? --body-unit, with its unit, such as 1mm.")]
        [TestCase("--body-unit", "1mm", "--body-unit is the length of a unit of the mesh of --body, which is missing.")]
        [TestCase("--name", "9 moths", "'9 moths' is no name of an insect")]
        public void WhatIsMissingOrWrong_IsOneLine_AndNothingIsWritten(string option, string value, string message)
        {
            List<string> words = ["--wing", m_Hind, "--length", "50mm", "--mass", "1.6g", "--frequency", "25Hz"];
            int at = words.IndexOf(option);
            if (at >= 0)
                words.RemoveRange(at, 2);
            if (value != null)
                words.AddRange([option, value]);
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, .. words]), Is.EqualTo(2));
            Assert.That(m_Run.Errors.Trim(), Does.Contain(message).And.Not.Contain("\n"));
            Assert.That(Directory.Exists(m_Run.Out), Is.False);
        }

        [Test]
        public void TwoPictures_NeedAnInsectWithTwoKindsOfWings_AndThreeAreTooMany()
        {
            string[] rest = ["--length", "50mm", "--mass", "1.6g", "--frequency", "25Hz"];
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", m_Fore, m_Hind, "--like", "monarch", .. rest]), Is.EqualTo(2));
            Assert.That(m_Run.Errors, Does.Contain("The monarch has one kind of wing").And.Contain("swallowtail"));
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", m_Fore, "--length", "5cm", "4cm", .. rest[2..]]), Is.EqualTo(2));
            Assert.That(m_Run.Errors, Does.Contain("--length takes one length for each wing: 1, not 2."));
            Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", m_Fore, m_Hind, m_Fore, .. rest]), Is.EqualTo(2));
            Assert.That(Directory.Exists(m_Run.Out), Is.False);
        }

        private string FilePath => Path.Combine(m_Run.Out, "out.insect.json");

        private void New(params string[] words) => Assert.That(m_Run.Run(["insect", "new", m_Run.Out, .. words]), Is.Zero, m_Run.Errors);

        private JsonNode ReadFile(string name = "out") => JsonNode.Parse(File.ReadAllText(Path.Combine(m_Run.Out, name + ".insect.json")));

        private static JsonNode Wing(JsonNode file, int k) => file["wings"].AsObject().ElementAt(k).Value;
    }
}
