using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Damaged insect files and kinematics: each flies, or one line says what is wrong and the exit code is 2.</summary>
    public sealed class DamagedFileTests
    {
        private const int k_Sample = 5, k_All = 600, k_Kinematics = 5;

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void ADamagedInsectFile_FliesOrIsRefusedInOneLine() => FlyInsects(0, k_Sample);

        [Test]
        public void DamagedKinematics_FlyOrAreRefusedInOneLine() => FlyKinematics(0, k_Kinematics);

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void DamagedSummaries_FlyAgainOrAreRefusedInOneLine() => FlySummaries(0, k_Kinematics);

        [Test, Explicit, Category("Long")]
        public void SixHundredDamagedSummaries_FlyAgainOrAreRefusedInOneLine() => FlySummaries(k_Kinematics, k_Kinematics + k_All);

        [Test, Explicit, Category("Long")]
        public void SixHundredDamagedInsectFiles_FlyOrAreRefusedInOneLine() => FlyInsects(k_Sample, 2 * k_Sample + k_All);

        [Test, Explicit, Category("Long")]
        public void SixHundredDamagedKinematics_FlyOrAreRefusedInOneLine() => FlyKinematics(k_Kinematics, k_Kinematics + k_All);

        [Test, Explicit, Category("Long")]
        public void SixHundredDamagedStudies_AreFlownOrRefusedInOneLine()
        {
            const string k_Study = """
                { "version": 1, "insect": "monarch", "options": ["--speed", "0"], "design": "latin-hypercube", "count": 2, "seed": 3,
                  "parameters": [ { "key": "insect.beat.frequencyHertz", "from": 8, "to": 13 },
                    { "key": "substeps", "from": 12, "to": 24, "whole": true },
                    { "key": "elasticity", "from": 0.5, "to": 2, "scale": "logarithmic" } ],
                  "measures": ["lift_over_weight", "power_w"], "best": { "most": "lift_over_weight", "least": "power_w" } }
                """;
            const string k_Free = """
                { "version": 1, "insect": "firefly", "options": ["--free", "--pilot", "wander", "--seconds", "0.2"], "seed": 2,
                  "parameters": [ { "key": "gust-y", "from": -2, "to": 2, "steps": 2 },
                    { "key": "erratic", "from": 0, "to": 1, "steps": 2 } ],
                  "repeats": 2, "measures": ["tumble_s", "lift_over_weight", "lowest_m_least"] }
                """;
            int refused = 0;
            for (int seed = 0; seed < k_All; seed++)
            {
                using var run = new CommandRun();
                string damaged = DamagedJson.Of(seed % 3 == 0 ? k_Free : k_Study, seed);
                string file = run.Write("one.study.json", damaged.Replace("\"count\": 2000", "\"count\": 20"));
                refused += AssertFliesOrRefuses(run, $"seed {seed}", file, ["study", file, "--workers", "1", "--out", run.Out]) ? 0 : 1;
            }

            Assert.That(refused, Is.InRange(k_All / 10, k_All * 19 / 20), "some are damaged, and some fly");
        }

        // Most fly on the spot; of eleven one flies freely, and of one the numbers are compared with those of real insects.
        private static void FlyInsects(int from, int to)
        {
            string[] names = [.. InsectCatalogue.Names];
            string[] texts = [.. names.Select(name => InsectFileText.Write(InsectCatalogue.Find(name)))];
            int refused = 0;
            for (int seed = from; seed < to; seed++)
            {
                using var run = new CommandRun();
                string file = run.Write("one.insect.json", DamagedJson.Of(texts[seed % texts.Length], seed));
                string[] words = (seed % 11) switch
                {
                    0 => ["fly", file, "--free", "--seconds", "0.05", "--no-pictures", "--out", run.Out],
                    1 => ["species", file, "--check"],
                    2 => ["fly", file, "--variant", "flight", "--substeps", "12", "--elements", "32", "--no-pictures", "--out", run.Out],
                    _ => ["fly", file, "--substeps", "12", "--elements", "32", "--no-pictures", "--out", run.Out],
                };
                refused += AssertFliesOrRefuses(run, $"seed {seed}, {names[seed % names.Length]}", file, words) ? 0 : 1;
            }

            TestContext.Out.WriteLine($"{refused} of {to - from} refused");
            Assert.That(refused, Is.InRange((to - from) / 4, (to - from) * 19 / 20), "some are damaged, and some fly");
        }

        private static void FlyKinematics(int from, int to)
        {
            string folder = Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics");
            string[] files = Directory.GetFiles(folder, "*.json").Order().ToArray();
            int refused = 0;
            for (int seed = from; seed < to; seed++)
            {
                using var run = new CommandRun();
                string file = run.Write("motion.json", DamagedJson.Of(File.ReadAllText(files[seed % files.Length]), seed));
                refused += AssertFliesOrRefuses(
                    run, $"seed {seed}, {files[seed % files.Length]}", file, "fly", "dragonfly", "--kinematics", file, "--substeps", "12",
                    "--elements", "32", "--no-pictures", "--out", run.Out) ? 0 : 1;
            }

            TestContext.Out.WriteLine($"{refused} of {to - from} refused");
            Assert.That(refused, Is.InRange((to - from) / 4, (to - from) * 19 / 20), "some are damaged, and some fly");
        }

        // What flies again alone: the words of the command, the files and the insect, without the numbers that came of it.
        private static void FlySummaries(int from, int to)
        {
            using var first = new CommandRun();
            string[] options = ["--substeps", "12", "--elements", "32", "--no-pictures"];
            Assert.That(first.Run(["fly", "firefly", "--speed", "0.4", .. options, "--out", first.Out]), Is.Zero, first.Errors);
            JsonObject summary = JsonNode.Parse(File.ReadAllText(Path.Combine(first.Out, "summary.json"))).AsObject();
            foreach (string key in summary.Select(member => member.Key).ToArray())
            {
                if (key is not ("version" or "command" or "inputs" or "insect"))
                    summary.Remove(key);
            }

            // A third of the damage to the words.
            var words = new JsonObject { ["command"] = summary["command"].DeepClone(), ["inputs"] = new JsonArray() };
            int refused = 0;
            for (int seed = from; seed < to; seed++)
            {
                using var run = new CommandRun();
                string text = seed % 3 > 0
                    ? DamagedJson.Of(summary.ToJsonString(), seed) : Joined(DamagedJson.Of(words.ToJsonString(), seed));
                string file = run.Write("summary.json", text);
                refused += AssertFliesOrRefuses(run, $"seed {seed}", file, "fly", "--from", file, "--out", run.Out) ? 0 : 1;
            }

            TestContext.Out.WriteLine($"{refused} of {to - from} refused");
            Assert.That(refused, Is.InRange((to - from) / 4, (to - from) * 19 / 20), "some are damaged, and some fly");

            string Joined(string damaged)
            {
                int end = damaged.TrimEnd().LastIndexOf('}');
                return end < 0 ? damaged
                    : damaged[..end] + $", \"version\": \"0.3.0\", \"insect\": {summary["insect"].ToJsonString()}" + damaged[end..];
            }
        }

        // Returns true where it flies.
        private static bool AssertFliesOrRefuses(CommandRun run, string what, string file, params string[] words)
        {
            int code = run.Run(words);
            string errors = run.Errors.TrimEnd('\n');
            Assert.That(code, Is.Zero.Or.EqualTo(2), $"{what}: {errors}\n{File.ReadAllText(file)}");
            if (code == 2)
            {
                TestContext.Out.WriteLine($"{what}: {errors.Replace(run.Folder, "")}");
                Assert.That(errors, Is.Not.Empty.And.Not.Contains("\n"), what);
                Assert.That(errors, Does.Contain(file).Or.Contains("has no trim table for these numbers"), what);
                Assert.That(errors, Has.Length.LessThan(500), what);
                Assert.That(errors.Any(letter => char.IsControl(letter)), Is.False, what);
                Assert.That(Directory.Exists(run.Out), Is.False, what);
                return false;
            }

            Assert.That(errors, Is.Empty, what);
            if (words[0] == "fly")
            {
                string summary = File.ReadAllText(Path.Combine(run.Out, "summary.json"));
                using var parsed = JsonDocument.Parse(summary);
                Assert.That(parsed.RootElement.GetProperty("lift_over_weight").ValueKind, Is.EqualTo(JsonValueKind.Number), what);
                Assert.That(Regex.IsMatch(File.ReadAllText(Path.Combine(run.Out, "forces.csv")), "NaN|Infinity|∞"), Is.False, what);
            }

            return true;
        }
    }
}
