using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    public sealed class SpeciesCommandTests
    {
        [Test]
        public void TheList_NamesEverySpecies_AndItsVariants()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("species"), Is.Zero, run.Errors);

            foreach (InsectDefinition species in InsectCatalogue.All)
                Assert.That(run.Output, Does.Contain(species.Name));
            Assert.That(run.Output, Does.Contain("biological").And.Contain("12568"));
        }

        [Test]
        public void TheList_HasTheNumbersOfEachSpeciesMainWing_InTheirUnits()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("species"), Is.Zero, run.Errors);
            string[][] rows = TerminalTable.Behind(run.Output, "Species");
            Assert.That(rows[0], Is.EqualTo(new[] { "", "wings", "triangles", "length, mm", "Hz", "flap, °", "k_e", "variants" }));
            Assert.That(rows, Has.Length.EqualTo(1 + InsectCatalogue.All.Count));
            for (int k = 0; k < InsectCatalogue.All.Count; k++)
            {
                InsectDefinition species = InsectCatalogue.All[k];
                WingPreset preset = species.Wings[0].CreatePreset();
                double[] told = [.. rows[k + 1][2..7].Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
                // A name may be broken at a hyphen where the table is narrow.
                Assert.That(rows[k + 1][0].Replace("- ", "-"), Is.EqualTo(species.Name));
                Assert.That(rows[k + 1][1], Is.EqualTo(string.Join(", ", species.Wings.Select(wing => wing.Name))));
                Assert.That(told[0], Is.EqualTo(species.TriangleCount));
                Assert.That(told[1], Is.EqualTo(1000 * preset.Size.wingLength).Within(1e-4));
                Assert.That(told[2], Is.EqualTo(preset.Beat.maxFrequency).Within(1e-4));
                Assert.That(told[3], Is.EqualTo(preset.Beat.flapRange).Within(1e-4));
                Assert.That(told[4], Is.EqualTo(preset.Stiffness.elasticity).Within(0.1).Percent);
                Assert.That(rows[k + 1][7], Is.EqualTo(string.Join(", ", species.Variants).ToLowerInvariant()));
                UnityEngine.Object.DestroyImmediate(preset);
            }
        }

        [TestCase("firefly")]
        [TestCase("fishfly")]
        public void OneSpecies_HasEveryNumberOfEveryVariantAndWing_OnTheTerminalAndInTheFile(string name)
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "one.json");
            Assert.That(run.Run("species", name, "--json", file), Is.Zero, run.Errors);
            using var json = JsonDocument.Parse(File.ReadAllText(file));
            JsonElement sheet = json.RootElement.GetProperty("species").EnumerateArray().Single();
            InsectDefinition species = InsectCatalogue.Find(name);
            Assert.That((sheet.GetProperty("display_name").GetString(), sheet.GetProperty("triangles").GetInt32()),
                Is.EqualTo((species.DisplayName, species.TriangleCount)));
            for (int k = 0; k < species.Wings.Count; k++)
            {
                WingDefinition wing = species.Wings[k];
                JsonElement told = sheet.GetProperty("wings")[k];
                string[][] rows = TerminalTable.Behind(
                    run.Output, $"{species.DisplayName}: {wing.Name}, {wing.TriangleCount} triangles on each side");
                Assert.That((told.GetProperty("name").GetString(), told.GetProperty("triangles").GetInt32(),
                    told.GetProperty("chains").GetInt32(),
                    told.GetProperty("joints_per_chain").GetInt32()),
                        Is.EqualTo((wing.Name, wing.TriangleCount, wing.Chains, wing.JointsPerChain)));
                Assert.That(rows[0][1..], Is.EqualTo(wing.Variants.Select(variant => variant.ToString().ToLowerInvariant())));
                for (int column = 0; column < wing.Variants.Count; column++)
                {
                    WingPreset preset = wing.CreatePreset(variant: wing.Variants[column]);
                    JsonElement numbers = told.GetProperty("variants").GetProperty(rows[0][1 + column]);
                    Assert.That(numbers.EnumerateObject().Count(), Is.EqualTo(rows.Length - 1));
                    foreach (FlownParameter parameter in FlownParameters.OfSpecies)
                    {
                        string[] row = rows.Single(cells => cells[0].Split(',')[0] == parameter.Name);
                        double own = parameter.Of(preset);
                        Assert.That(numbers.GetProperty(parameter.Name.Replace('-', '_')).GetSingle(), Is.EqualTo((float)own),
                            parameter.Name);
                        Assert.That(double.Parse(row[1 + column], NumberStyles.Float, CultureInfo.InvariantCulture),
                            Is.EqualTo(own).Within(6e-5 + (own != 0 && System.Math.Abs(own) < 1e-3 ? 5e-4 * own - 6e-5 : 0)),
                                parameter.Name);
                        Assert.That(json.RootElement.GetProperty("units").GetProperty(parameter.Name.Replace('-', '_')).GetString(),
                            Is.EqualTo(parameter.Unit));
                    }

                    UnityEngine.Object.DestroyImmediate(preset);
                }
            }

            Assert.That(sheet.GetProperty("sources").EnumerateArray().Select(one => (one.GetProperty("quantity").GetString(),
                    one.GetProperty("variant").GetString(), one.GetProperty("value").GetString(), one.GetProperty("source").GetString())),
                Is.EqualTo(species.Sources.Select(one => (one.Quantity, one.Variant.ToString().ToLowerInvariant(), one.Value,
                    one.Source))));
            string[][] sources = TerminalTable.Behind(run.Output, "Sources");
            Assert.That(sources[0], Is.EqualTo(new[] { "number", "variant", "value", "source" }));
            Assert.That(run.Output.Split('\n')[^2], Does.StartWith("╰"), "nothing behind the sources");
        }

        [Test]
        public void OneSpecies_IsShownWithItsNumbersAndSources()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("species", "Firefly"), Is.Zero, run.Errors);

            Assert.That(run.Output, Does.Contain("flap-range").And.Contain("156").And.Contain("62 Hz").And.Contain("Table 1").And
                .Contain("1.39e-7"));
        }

        [Test]
        public void Json_HasEveryNumberOfEveryVariant()
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "species.json");

            Assert.That(run.Run("species", "--json", file), Is.Zero, run.Errors);

            using var json = JsonDocument.Parse(File.ReadAllText(file));
            JsonElement[] species = json.RootElement.GetProperty("species").EnumerateArray().ToArray();
            Assert.That(species.Select(one => one.GetProperty("name").GetString()), Is.EqualTo(InsectCatalogue.Names));
            JsonElement firefly = species.Single(one => one.GetProperty("name").GetString() == "firefly");
            JsonElement variants = firefly.GetProperty("wings")[0].GetProperty("variants");
            Assert.That(variants.EnumerateObject().Select(variant => variant.Name),
                Is.EqualTo(new[] { "standard", "biological", "expressive", "flight" }));
            Assert.That(variants.GetProperty("biological").GetProperty("max_frequency").GetDouble(), Is.EqualTo(62));
            Assert.That(json.RootElement.GetProperty("units").GetProperty("max_frequency").GetString(), Is.EqualTo("Hz"));
            Assert.That(firefly.GetProperty("sources").GetArrayLength(), Is.EqualTo(InsectCatalogue.Find("firefly").Sources.Count));
        }
    }
}
