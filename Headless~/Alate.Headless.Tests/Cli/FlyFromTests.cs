using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary><c>fly --from summary.json</c>: the same run again, from what its summary says.</summary>
    public sealed class FlyFromTests
    {
        private static readonly string s_Kinematics = Path.Combine(
            PackageRoot.Find(), "Documentation~", "kinematics", "dragonfly-flight-1.json");

        private static readonly string s_Hawkmoth = FlownInsects.HawkmothFile;

        [Test]
        public void AFlightOnTheSpot_IsFlownAgain_ToTheLastByte() => FliesAgain(
            "fly", "monarch", "--variant", "expressive", "--speed", "0.8", "--climb", "-0.2", "--pitch", "12.5", "--wind", "0.5,0,-0.25",
            "--seconds", "0.2", "--lag", "0.3", "--elasticity", "0.5", "--substeps", "20", "--elements", "100", "--coefficients",
            "flatplate", "--induced-flow", "1.2", "--added-mass", "--no-pictures");

        [Test]
        public void AFlightOfAPrescribedMotion_IsFlownAgain_ToTheLastByte() => FliesAgain(
            "fly", "dragonfly", "--kinematics", s_Kinematics, "--rigid", "--seconds", "0.1", "--no-pictures");

        [Test]
        public void AFreeFlight_IsFlownAgain_ToTheLastByte() => FliesAgain(
            "fly", "--free", "monarch", "--pilot=wander", "--seed", "7", "--gust", "0,-1,0", "--seconds", "0.4", "--step", "0.01", "--aid",
            "0.5", "--no-pictures");

        [Test, Explicit, Category("Long")]
        public void PicturesToo_AreFlownAgain_ToTheLastByte([Values("swallowtail", "firefly", "fishfly", "snailfish")] string name) =>
            FliesAgain("fly", name, "--seconds", "1", "--view", "top");

        private static void FliesAgain(params string[] words)
        {
            using var run = new CommandRun();
            FliesAgain(run, words);
        }

        private static void FliesAgain(CommandRun run, string[] words, Action between = null)
        {
            string again = Path.Combine(run.Folder, "again");
            Assert.That(run.Run([.. words, "--out", run.Out]), Is.Zero, run.Errors);
            between?.Invoke();
            Assert.That(run.Run("fly", "--from", Path.Combine(run.Out, "summary.json"), "--out", again), Is.Zero, run.Errors);
            AreAlike(run.Out, again);
        }

        // The cost of a substep is measured by the clock; nothing else may differ.
        private static void AreAlike(string folder, string again)
        {
            string[] names = Directory.GetFiles(folder).Select(Path.GetFileName).Order().ToArray();
            Assert.That(Directory.GetFiles(again).Select(Path.GetFileName).Order(), Is.EqualTo(names));
            foreach (string name in names)
            {
                byte[][] bytes = new[] { folder, again }.Select(one => Path.Combine(one, name)).Select(Bytes).ToArray();
                Assert.That(bytes[1].SequenceEqual(bytes[0]), Is.True, name);
            }
        }

        private static byte[] Bytes(string path) => Path.GetExtension(path) == ".json"
            ? Encoding.UTF8.GetBytes(string.Join("\n", File.ReadLines(path).Where(line => !line.Contains("us_per_substep"))))
            : File.ReadAllBytes(path);

        [Test]
        public void TheInsectOfAFile_IsInTheSummary_AndFliesWithoutTheFile()
        {
            using var run = new CommandRun();
            string file = run.Write("moth.insect.json", File.ReadAllText(s_Hawkmoth).Replace("\"trims\": \"hawkmoth.trims\",", ""));
            FliesAgain(run, ["fly", file, "--variant", "flight", "--speed", "0", "--no-pictures"], () => File.Delete(file));
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json")));
            Assert.That((double)summary["insect"]["massMilligrams"], Is.EqualTo(1579));
            Assert.That((string)summary["insect"]["like"], Is.EqualTo("monarch"));
            Assert.That((string)summary["insect_file"], Is.EqualTo(file));
        }

        [Test]
        public void AnInsectOfOwnMeshes_IsFlownAgain_AndItsFilesAreHashed()
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());
            string file = run.Write("own.insect.json", """
                { "version": 1, "name": "own", "like": "dragonfly", "massMilligrams": 700,
                  "wings": { "wing": { "mesh": "wing.obj", "skeleton": "wing.json", "lengthMillimetres": 40, "massMilligrams": 10,
                    "flexuralStiffnessNewtonSquareMetres": [[1e-5], [1e-5], [1e-5], [1e-5], [1e-5]] } },
                  "body": { "scale": 0.9 } }
                """);
            FliesAgain(run, ["fly", file, "--seconds", "0.2", "--no-pictures"]);
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json")));
            var inputs = summary["inputs"].AsArray().ToDictionary(input => (string)input["file"], input => (string)input["sha256"]);
            Assert.That(inputs.Keys, Is.EquivalentTo(new[] { file, mesh, skeleton }));
            foreach ((string path, string hash) in inputs)
                Assert.That(hash, Is.EqualTo(Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(path))).ToLowerInvariant()));

            File.AppendAllText(mesh, "# another\n");
            Assert.That(run.Run("fly", "--from", Path.Combine(run.Out, "summary.json"), "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain($"'{mesh}' is another file than the one that was flown: its SHA-256 is "));
            File.Delete(mesh);
            Assert.That(run.Run("fly", "--from", Path.Combine(run.Out, "summary.json"), "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain($"Cannot read '{mesh}': there is no such file."));
        }

        [Test]
        public void AWingByOptions_IsFlownAgain()
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());
            FliesAgain(run, ["fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--seconds", "0.2", "--no-pictures"]);
        }

        /// <summary>The insect in the summary is what <c>species --json</c> writes.</summary>
        [Test]
        public void TheInsect_IsThatOfSpeciesJson_AndTheCommandIsThatOfTheUser()
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "one.insect.json"), record = Path.Combine(run.Folder, "record.txt");
            Assert.That(run.Run("species", "monarch", "--json", file), Is.Zero, run.Errors);
            Assert.That(run.Run("fly", "monarch", "--free", "--record", record, "--seconds", "0.1", "--no-pictures", "--out", run.Out),
                Is.Zero, run.Errors);
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json")));
            Assert.That(JsonNode.DeepEquals(summary["insect"], JsonNode.Parse(File.ReadAllText(file))), Is.True);
            Assert.That(summary["command"].AsArray().Select(word => (string)word),
                Is.EqualTo(new[] { "fly", "monarch", "--free", "--seconds", "0.1", "--no-pictures" }));
            Assert.That((string)summary["version"], Is.EqualTo(PackageRoot.Version));
            Assert.That((int)summary["options"]["seed"], Is.EqualTo(1));
            File.Delete(record);
            Assert.That(run.Run("fly", "--from", Path.Combine(run.Out, "summary.json"), "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(File.Exists(record), Is.False, "The recording is not written over.");
        }

        // A number of the summary counts, not that of the catalogue.
        [Test]
        public void AnInsectThatIsChangedInTheSummary_FliesAsItSays()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", "monarch", "--seconds", "0.2", "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
            string path = Path.Combine(run.Out, "summary.json");
            var summary = JsonNode.Parse(File.ReadAllText(path));
            double before = (double)summary["lift_over_weight"];
            summary["insect"]["massMilligrams"] = 856;
            string changed = run.Write("changed.json", summary.ToJsonString());
            Assert.That(run.Run("fly", "--from", changed, "--out", run.Out), Is.Zero, run.Errors);
            Assert.That((double)JsonNode.Parse(File.ReadAllText(path))["lift_over_weight"], Is.EqualTo(before / 2).Within(1e-3).Percent);
        }

        [TestCase("command", "[\"bake\", \"monarch\"]", "command: it is no command of 'fly'")]
        [TestCase("command", "[\"fly\", \"--from\", \"x\"]", "command: it is no command of 'fly'")]
        [TestCase("command", "[\"fly\", \"monarch\", \"--sped\", \"1\"]", "command: 'fly' has no option '--sped'. Did you mean '--speed'?")]
        [TestCase("command", "[\"fly\", \"monarch\", \"--out\", \"x\"]", "command: it is no command of 'fly'")]
        [TestCase("command", "[\"fly\", \"monarch\", \"--free\", \"--record\", \"x\"]", "command: it is no command of 'fly'")]
        [TestCase("command", "[\"fly\", 3]", "command[1]: it must be a text, not 3")]
        [TestCase("command", "7", "command: it must not be 7")]
        [TestCase("command", null, "'command' is missing, so that it is no summary of 'fly' that can be flown again")]
        [TestCase("insect", "{}", "insect: 'version' is missing")]
        [TestCase("insect", "[]", "insect: it must not be a list")]
        [TestCase("inputs", "[{\"file\": \"a\"}]", "inputs[0]: 'sha256' is missing")]
        public void ADamagedSummary_IsRefused_WithLineAndPlace(string key, string value, string problem)
        {
            using var run = new CommandRun();
            string insect = InsectFileText.Write(InsectCatalogue.Find("monarch"));
            var summary = new JsonObject
            {
                ["version"] = "0.3.0",
                ["command"] = new JsonArray("fly", "monarch"),
                ["inputs"] = new JsonArray(),
                ["insect"] = JsonNode.Parse(insect),
            };
            if (value == null)
                summary.Remove(key);
            else
                summary[key] = JsonNode.Parse(value);
            string file = run.Write("summary.json", summary.ToJsonString(new JsonSerializerOptions { WriteIndented = true }));
            Assert.That(run.Run("fly", "--from", file, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
            Assert.That(run.Errors, Does.Contain(file + ": ").And.Contain(problem));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void OtherOptions_AreRefused([Values("--speed", "--free", "SPECIES")] string option)
        {
            using var run = new CommandRun();
            IEnumerable<string> words = option switch { "--speed" => ["--speed", "1"], "--free" => ["--free"], _ => ["monarch"] };
            Assert.That(run.Run(["fly", "--from", "summary.json", .. words]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain($"--from takes no {option}: the file says it."));
        }

        [Test]
        public void ASummaryOfAnotherVersion_IsFlown_AndSaidSo()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", "monarch", "--seconds", "0.1", "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
            string file = run.Write("old.json", File.ReadAllText(Path.Combine(run.Out, "summary.json"))
                .Replace($"\"version\": \"{PackageRoot.Version}\"", "\"version\": \"0.2.9\""));
            Assert.That(run.Run("fly", "--from", file, "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain($"Flown by version 0.2.9; this is {PackageRoot.Version}, whose numbers may differ."));
        }
    }
}
