using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
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
