using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    public sealed class InsectFileTests
    {
        private const string k_Hawkmoth = """
            {
              "version": 1,
              "name": "hawkmoth",
              "like": "monarch",
              "massMilligrams": 1500,
              "beat": { "frequencyHertz": 26, "flapRangeDegrees": 110 },
              "wings": { "wing": { "lengthMillimetres": 50, "massMilligrams": 47 } }
            }
            """;

        [Test]
        public void AFileOfASpecies_FliesAsTheSpecies_ToTheLastByte() => FliesAlike("dragonfly", InsectVariant.Flight, "--no-pictures");

        [Test, Explicit, Category("Long")]
        public void FilesOfAllSpecies_FlyAsTheSpecies_ToTheLastByte(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "snailfish", "dragonfly")] string name)
        {
            foreach (InsectVariant variant in InsectCatalogue.Find(name).Variants)
                FliesAlike(name, variant);
        }

        // The cost of a substep is measured by the clock, and the words of the command name the file; nothing else may differ.
        private static void FliesAlike(string name, InsectVariant variant, params string[] options)
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "own.insect.json"), word = variant.ToString().ToLowerInvariant();
            Assert.That(run.Run("species", name, "--json", file), Is.Zero, run.Errors);
            string[] folders = [Path.Combine(run.Folder, "a"), Path.Combine(run.Folder, "b")];
            string beats = name == "snailfish" ? "1" : "0.3";
            foreach ((string insect, string folder) in new[] { name, file }.Zip(folders))
            {
                Assert.That(
                    run.Run(["fly", insect, "--variant", word, "--seconds", beats, "--out", folder, .. options]), Is.Zero, run.Errors);
            }

            string[] names = Directory.GetFiles(folders[0]).Select(Path.GetFileName).ToArray();
            Assert.That(names, Has.Length.EqualTo(options.Length == 0 ? 7 : 5));
            foreach (string one in names)
            {
                byte[][] bytes = folders.Select(folder => Bytes(Path.Combine(folder, one))).ToArray();
                Assert.That(bytes[1].AsSpan().SequenceEqual(bytes[0]), $"{name}, {word}: {one}");
            }
        }

        private static byte[] Bytes(string path)
        {
            if (Path.GetExtension(path) != ".json")
                return File.ReadAllBytes(path);
            JsonObject summary = JsonNode.Parse(File.ReadAllText(path)).AsObject();
            foreach (string key in new[] { "us_per_substep", "command", "inputs", "insect_file" })
                summary.Remove(key);
            return System.Text.Encoding.UTF8.GetBytes(summary.ToJsonString());
        }

        [Test]
        public void AFileOfASpecies_HasItsTrims_BodyAndSources()
        {
            using var run = new CommandRun();
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                InsectDefinition read = Read(run, InsectFileText.Write(species));
                Assert.That(read.Name, Is.EqualTo(species.Name));
                Assert.That(read.DisplayName, Is.EqualTo(species.DisplayName));
                Assert.That(read.Variants, Is.EqualTo(species.Variants));
                Assert.That(read.FlightParts, Is.EqualTo(species.FlightParts));
                Assert.That(read.Sources, Is.EqualTo(species.Sources));
                Assert.That(read.Body.CreateSurface(1f).positions, Is.EqualTo(species.Body.CreateSurface(1f).positions));
                using FlightModel own = CatalogueFlight.CreateModel(read), model = CatalogueFlight.CreateModel(species);
                Assert.That(own.Key, Is.EqualTo(model.Key), species.Name);
                using TrimTable table = CatalogueFlight.CreateTable(read, own);
                Assert.That(table, Is.Not.Null, species.Name);
            }
        }

        [Test]
        public void NumbersThatAreSaid_HoldInEveryVariant_AndTheRestIsThatOfTheSpecies()
        {
            using var run = new CommandRun();
            InsectDefinition moth = Read(run, k_Hawkmoth), monarch = InsectCatalogue.Find("monarch");
            foreach (InsectVariant variant in moth.Variants)
            {
                WingPreset said = moth.Wings[0].CreatePreset(variant: variant), like = monarch.Wings[0].CreatePreset(variant: variant);
                Assert.That(said.Size.insectMass, Is.EqualTo(1.5e-3f));
                Assert.That(said.Size.wingMass, Is.EqualTo(47e-6f));
                Assert.That(said.Size.wingLength, Is.EqualTo(0.05f));
                Assert.That(said.Beat.maxFrequency, Is.EqualTo(26f));
                Assert.That(said.Beat.flapRange, Is.EqualTo(110f));
                Assert.That(said.Beat.frequencyFloor, Is.EqualTo(1f), "A frequency that is said is flown at every speed.");
                Assert.That(said.Beat.amplitudeFloor, Is.EqualTo(1f));
                Assert.That(said.Beat.featherRange, Is.EqualTo(like.Beat.featherRange));
                Assert.That(said.Stiffness, Is.EqualTo(like.Stiffness));
                Assert.That(said.Wave, Is.EqualTo(like.Wave));
                Assert.That(said.Size.fluidDensity, Is.EqualTo(like.Size.fluidDensity));
                Assert.That(said.Rest.feet.y, Is.EqualTo(like.Rest.feet.y * 50f / 61f).Within(1e-6f));
                UnityEngine.Object.DestroyImmediate(said);
                UnityEngine.Object.DestroyImmediate(like);
            }
        }

        [Test]
        public void ASmallerWing_MakesShapeHingeAndBodySmaller()
        {
            using var run = new CommandRun();
            InsectDefinition moth = Read(run, k_Hawkmoth), monarch = InsectCatalogue.Find("monarch");
            const float k_Share = 50f / 61f;
            UnityEngine.Vector3[] small = moth.Wings[0].CreateSurface(WingSide.Right).positions,
                large = monarch.Wings[0].CreateSurface(WingSide.Right).positions;
            Assert.That(small.Max(point => point.x), Is.EqualTo(0.5f).Within(1e-4f), "50 mm, ten units a metre");
            Assert.That(small.Min(point => point.z), Is.EqualTo(k_Share * large.Min(point => point.z)).Within(1e-5f));
            Assert.That(moth.Wings[0].Hinge.x, Is.EqualTo(k_Share * monarch.Wings[0].Hinge.x).Within(1e-7f));
            Assert.That(moth.FlightParts[1].halfAxes.z, Is.EqualTo(k_Share * monarch.FlightParts[1].halfAxes.z).Within(1e-7f));
            Assert.That(moth.Body.CreateSurface(1f).positions.Max(point => point.z),
                Is.EqualTo(k_Share * monarch.Body.CreateSurface(1f).positions.Max(point => point.z)).Within(1e-6f));
        }

        [Test]
        public void AVariantOfTheFile_HasItsOwnNumbers()
        {
            using var run = new CommandRun();
            InsectDefinition moth = Read(run, k_Hawkmoth.Replace("\"wings\": {", """
                "variants": {
                    "flight": { "beat": { "frequencyHertz": 24 }, "wings": { "wing": { "massMilligrams": 40 } } },
                    "biological": { "massMilligrams": 1400 }
                },
                "wings": {
                """));
            Assert.That(moth.Variants, Is.EqualTo(new[]
            {
                InsectVariant.Standard, InsectVariant.Expressive, InsectVariant.Flight, InsectVariant.Biological,
            }));
            float[] Numbers(InsectVariant variant)
            {
                WingPreset preset = moth.Wings[0].CreatePreset(variant: variant);
                float[] numbers = [preset.Beat.maxFrequency, 1e6f * preset.Size.wingMass, 1e6f * preset.Size.insectMass];
                UnityEngine.Object.DestroyImmediate(preset);
                return numbers;
            }

            Assert.That(Numbers(InsectVariant.Standard), Is.EqualTo(new[] { 26f, 47f, 1500f }).Within(1e-3f));
            Assert.That(Numbers(InsectVariant.Flight), Is.EqualTo(new[] { 24f, 40f, 1500f }).Within(1e-3f));
            Assert.That(Numbers(InsectVariant.Biological), Is.EqualTo(new[] { 26f, 47f, 1400f }).Within(1e-3f));
        }

        [TestCase("\"massMilligrams\": 1500", "\"massGrams\": 1.5", "line 5, massGrams: unknown key; is it massMilligrams?")]
        [TestCase("\"massMilligrams\": 1500", "\"colour\": 3", "line 5, colour: unknown key; known: $schema, version")]
        [TestCase("\"massMilligrams\": 1500", "\"massMilligrams\": \"1.5 g\"",
            "line 5, massMilligrams: it must be a number from 0.01 to 10000000 milligrams, not '1.5 g'.")]
        [TestCase("\"massMilligrams\": 1500", "\"massMilligrams\": 1e30",
            "line 5, massMilligrams: 1e30 is out of range: a number from 0.01")]
        [TestCase("\"massMilligrams\": 1500", "\"massMilligrams\": 1500, \"massMilligrams\": 1",
            "line 5, massMilligrams: the key stands there twice.")]
        [TestCase("110 }", "220 }", "line 6, beat.flapRangeDegrees: 220 is out of range: a number from 0 to 180 degrees is allowed.")]
        [TestCase("{ \"frequencyHertz\": 26, \"flapRangeDegrees\": 110 }", "[26, 110]", "line 6, beat: it must be an object, not a list.")]
        [TestCase("\"lengthMillimetres\": 50", "\"lengthMetres\": 0.05",
            "line 7, wings.wing.lengthMetres: unknown key; is it lengthMillimetres?")]
        [TestCase("\"wing\": {", "\"fin\": {",
            "line 7, wings.fin: the monarch has no such wing, so that it needs a mesh. The monarch has: wing.")]
        [TestCase("\"massMilligrams\": 47", "\"mesh\": \"wing.obj\"", "line 7, wings.wing: 'mesh' and 'skeleton' need one another")]
        [TestCase("\"massMilligrams\": 47", "\"massMilligrams\": 900",
            "line 7, wings.wing: the wings of the variant standard weigh as much")]
        [TestCase("\"massMilligrams\": 47", "\"flexuralStiffnessNewtonSquareMetres\": [[1e-6], [], []]",
            "line 7, wings.wing.flexuralStiffnessNewtonSquareMetres: it has 3 lists; the wing has 5 chains.")]
        [TestCase("\"like\": \"monarch\",", "", "line 1: 'like' is missing.")]
        [TestCase("\"monarch\"", "\"dodo\"", "line 4, like: it must be one of monarch, swallowtail")]
        [TestCase("\"hawkmoth\"", "\"../moth\"",
            "line 3, name: it must be a name of lower-case letters, digits and hyphens, not '../moth'.")]
        [TestCase("\"version\": 1", "\"version\": 2", "line 2, version: 2 is out of range: 1 is allowed.")]
        [TestCase("\"version\": 1,", "\"version\": 1", "line 3: not JSON at column")]
        public void AWrongFile_IsRefusedInOneLine_ThatNamesLineAndKey(string right, string wrong, string message)
        {
            using var run = new CommandRun();
            string file = run.Write("moth.insect.json", k_Hawkmoth.Replace(right, wrong));
            Assert.That(run.Run("fly", file, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors.TrimEnd(), Does.StartWith($"alate: {file}: {message}").And.Not.Contains("\n"));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void AMissingFile_IsNamed()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", "nowhere.insect.json"), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("Cannot read 'nowhere.insect.json': there is no such file."));
        }

        [Test]
        public void NumbersWrittenInTheUnitsOfAFile_ComeBack_WithTheSameBits()
        {
            var random = new Random(11);
            foreach (decimal perUnit in new[] { 1m, 1e3m, 1e6m })
            {
                for (int k = 0; k < 20000; k++)
                {
                    float value = (float)((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-9, 4)));
                    string written = FileNumber.ToFile(value, perUnit).ToString(CultureInfo.InvariantCulture);
                    Assert.That(FileNumber.ToPreset(written, perUnit), Is.EqualTo(value), written);
                }
            }
        }

        [Test]
        public void AWingOfOnesOwn_FliesInAFile_AsWithTheOptionsOfFly()
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());
            string file = run.Write("mine.insect.json", $$"""
                { "version": 1, "name": "mine", "like": "monarch",
                  "wings": { "wing": { "mesh": "{{Path.GetFileName(mesh)}}", "skeleton": "{{Path.GetFileName(skeleton)}}" } } }
                """);
            string byFile = Path.Combine(run.Folder, "file"), byOptions = Path.Combine(run.Folder, "options");
            Assert.That(run.Run("fly", file, "--no-pictures", "--out", byFile), Is.Zero, run.Errors);
            Assert.That(run.Run("fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--no-pictures", "--out", byOptions),
                Is.Zero, run.Errors);
            List<double>[] lift = new[] { byFile, byOptions }
                .Select(folder => Column(Path.Combine(folder, "forces.csv"), "force_y_n")).ToArray();
            double largest = lift[0].Max(Math.Abs);
            Assert.That(largest, Is.GreaterThan(0));
            for (int k = 0; k < lift[0].Count; k++)
                Assert.That(lift[1][k], Is.EqualTo(lift[0][k]).Within(1e-3 * largest), $"row {k}");
        }

        private static List<double> Column(string file, string name)
        {
            string[][] rows = File.ReadLines(file).Select(line => line.Split(',')).ToArray();
            int column = Array.IndexOf(rows[0], name);
            return rows.Skip(1).Select(row => double.Parse(row[column], CultureInfo.InvariantCulture)).ToList();
        }

        private static InsectDefinition Read(CommandRun run, string text) => KnownSpecies.Find(run.Write("one.insect.json", text));
    }
}
