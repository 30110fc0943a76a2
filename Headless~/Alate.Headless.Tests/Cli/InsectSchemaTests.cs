using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Json.Schema;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The schema of insect files and the manual's tables, and the reader beside a validator that is not ours.</summary>
    public sealed class InsectSchemaTests
    {
        private const string k_Begin = "<!-- keys: ALATE_WRITE_API=1 and InsectSchemaTests write them -->\n",
            k_End = "<!-- end of keys -->";

        private static readonly JsonSchema s_Schema = JsonSchema.FromText(FileSchema.Insect.Write());

        private static string Manual(string name) => Path.Combine(PackageRoot.Find(), "Documentation~", name);

        private static bool Writes => Environment.GetEnvironmentVariable("ALATE_WRITE_API") == "1";

        [Test]
        public void TheSchemaOfTheManual_IsThatOfTheReader()
        {
            string path = Manual(FileSchema.Insect.FileName);
            if (Writes)
                File.WriteAllText(path, FileSchema.Insect.Write());
            Assert.That(FileSchema.Insect.Write(), Is.EqualTo(File.ReadAllText(path)), "ALATE_WRITE_API=1 writes it.");
        }

        [Test]
        public void TheManualsTables_AreThoseOfTheReader()
        {
            string path = Manual("insect-file.md"), page = File.ReadAllText(path);
            int from = page.IndexOf(k_Begin, StringComparison.Ordinal) + k_Begin.Length, to = page.IndexOf(k_End, StringComparison.Ordinal);
            string now = page[..from] + FileSchema.Insect.WriteTables() + page[to..];
            if (Writes)
                File.WriteAllText(path, now);
            Assert.That(now, Is.EqualTo(File.ReadAllText(path)), "ALATE_WRITE_API=1 writes them.");
        }

        [Test]
        public void TheCommand_WritesTheSchema()
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "s.json");
            Assert.That(run.Run("species", "--schema", file), Is.Zero, run.Errors);
            Assert.That(File.ReadAllText(file), Is.EqualTo(FileSchema.Insect.Write()));
        }

        [Test]
        public void FilesOfTheCatalogue_AndOfTheManual_FollowTheSchema()
        {
            IEnumerable<string> texts = InsectCatalogue.All.Select(InsectFileText.Write)
                .Concat(Directory.GetFiles(Manual("insects"), "*.insect.json").Select(File.ReadAllText));
            foreach (string text in texts)
            {
                var options = new EvaluationOptions { OutputFormat = OutputFormat.List };
                EvaluationResults found = s_Schema.Evaluate(JsonNode.Parse(text), options);
                Assert.That(found.IsValid, Is.True, string.Join("\n", found.Details.Where(one => one.HasErrors)
                    .Select(one => $"{one.InstanceLocation}: {string.Join("; ", one.Errors.Values)}")));
            }
        }

        // Each value of a whole file is put wrong in several ways, and new keys are added: both must refuse the same files.
        [Test]
        public void TheReader_RefusesWhatTheSchemaRefuses_AndNothingElse() => AssertRefused(k => k % 9 == 0);

        [Test, Explicit, Category("Long")]
        public void TheReader_RefusesWhatTheSchemaRefuses_AtEveryOtherPlace() => AssertRefused(k => k % 9 != 0);

        private static void AssertRefused(Func<int, bool> isTried)
        {
            string whole = InsectFileText.Write(InsectCatalogue.Find("dragonfly"));
            JsonNode[] wrongs = ["text", -1e9, 1e12, 0.5, 1, true, new JsonArray(), new JsonArray(1, 2, 3), new JsonObject()];
            int refused = 0, tried = 0;
            foreach (string path in Paths(JsonNode.Parse(whole)).Where((_, k) => isTried(k)))
            {
                foreach (JsonNode wrong in wrongs)
                {
                    var file = JsonNode.Parse(whole);
                    Put(file, path, wrong.DeepClone());
                    bool isRead = Reads(file.ToJsonString(), out string problem);
                    Assert.That(isRead, Is.EqualTo(s_Schema.Evaluate(file).IsValid), $"{path}: {wrong.ToJsonString()}; {problem}");
                    Assert.That(problem, Does.Not.Contain("\n"));
                    tried++;
                    refused += isRead ? 0 : 1;
                }
            }

            Assert.That(refused, Is.InRange(tried / 2, tried - tried / 14));
        }

        [TestCase("fore wing", true)]
        [TestCase("Fore Wing", false)]
        [TestCase("", false)]
        public void NamesOfWings_HaveLowerCaseLetters(string name, bool isOne)
        {
            var file = JsonPlace.Read(new StringReader(
                $"{{ \"version\": 1, \"name\": \"own\", \"like\": \"dragonfly\", \"wings\": {{ \"{name}\": {{}} }} }}"));

            Assert.That(() => InsectKeys.File.Check(file),
                isOne ? Throws.Nothing : Throws.TypeOf<FormatException>().With.Message.Contains("it must be a name of lower-case letters"));
        }

        [Test]
        public void KeysOfNumbers_EndInTheirUnit()
        {
            string[] ratios =
            [
                "gravityShare", "frequencyFloor", "amplitudeFloor", "rootShare", "inertia", "elasticity", "damping", "dorsalAsymmetry",
                "inPlaneFactor", "torsionFactor", "springScale", "anchor", "springDamping", "strongestWind", "substepsPerBeat",
            ];
            string[] units =
            [
                "Millimetres", "Milligrams", "KilogramsPerCubicMetre", "Hertz", "MetresPerSecond", "Degrees", "HalfBeats", "Beats",
                "ChainLengths",
            ];
            IEnumerable<PresetKey> keys = InsectKeys.OfInsect.Concat(InsectKeys.OfWing)
                .Concat(InsectKeys.Groups.SelectMany(group => group.Keys));
            foreach (PresetKey key in keys.Where(key => key.Shape is not ChoiceShape))
                Assert.That(units.Any(key.Name.EndsWith) || ratios.Contains(key.Name), Is.True, key.Name);
        }

        private static bool Reads(string text, out string problem)
        {
            try
            {
                InsectKeys.File.Check(JsonPlace.Read(new StringReader(text)));
                problem = "";
                return true;
            }
            catch (FormatException wrong)
            {
                problem = wrong.Message;
                return false;
            }
        }

        private static IEnumerable<string> Paths(JsonNode node) => node switch
        {
            JsonObject whole => whole.SelectMany(member => Paths(member.Value).Select(path => $"{member.Key}/{path}")
                .Prepend(member.Key)),
            JsonArray list => list.SelectMany((item, k) => Paths(item).Select(path => $"{k}/{path}").Prepend($"{k}")),
            _ => [],
        };

        private static void Put(JsonNode root, string path, JsonNode value)
        {
            string[] keys = path.Split('/');
            JsonNode at = root;
            foreach (string key in keys[..^1])
                at = at is JsonArray list ? list[int.Parse(key)] : at[key];
            if (at is JsonArray last)
                last[int.Parse(keys[^1])] = value;
            else
                at[keys[^1]] = value;
        }
    }
}
