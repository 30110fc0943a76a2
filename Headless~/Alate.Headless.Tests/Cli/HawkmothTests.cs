using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The manual's insect file, a hawkmoth from published numbers, in the commands.</summary>
    public sealed class HawkmothTests
    {
        private static string File => FlownInsects.HawkmothFile;

        [Test]
        public void TheHawkmoth_CarriesItsWeight_AndIsAsStiffAsMeasured()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", File, "--speed", "0", "--pitch", "40", "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
            using var summary = JsonDocument.Parse(System.IO.File.ReadAllText(Path.Combine(run.Out, "summary.json")));
            double Number(string key) => summary.RootElement.GetProperty(key).GetDouble();
            Assert.That(summary.RootElement.GetProperty("species").GetString(), Is.EqualTo("hawkmoth"));
            Assert.That(Number("frequency_hz"), Is.EqualTo(26.1).Within(1e-3), "A frequency that is said is flown.");
            Assert.That(Number("lift_over_weight"), Is.EqualTo(1).Within(0.25));
            // Combes and Daniel 2003: log EI = 2.97 log span + 0.08, with a scatter of a factor of two.
            Assert.That(Number("wing_ei_n_m2"), Is.InRange(0.5 * 1.48e-4, 2 * 1.48e-4));
            Assert.That(Number("edge_stretch_max_pct"), Is.LessThan(6));
        }

        [Test]
        public void TheHawkmoth_HoversByItsOwnWings_AtAboutItsPublishedBeat()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("fly", File, "--free", "--pilot", "hover", "--seconds", "2", "--no-pictures", "--out", run.Out),
                Is.Zero, run.Errors);
            string[][] rows = System.IO.File.ReadLines(Path.Combine(run.Out, "trajectory.csv")).Select(line => line.Split(',')).ToArray();
            int frequency = System.Array.IndexOf(rows[0], "frequency_hz"), height = System.Array.IndexOf(rows[0], "y_m");
            Assert.That(rows.Skip(50).Average(row => double.Parse(row[frequency], System.Globalization.CultureInfo.InvariantCulture)),
                Is.EqualTo(26.1).Within(5).Percent);
            Assert.That(double.Parse(rows[^1][height], System.Globalization.CultureInfo.InvariantCulture), Is.EqualTo(0).Within(0.02));
        }

        [Test, Explicit, Category("Long")]
        [TestCase("trim", "FILE", "--speeds", "0,1", "--climbs", "0")]
        [TestCase("film", "FILE", "--beats", "1", "--frames", "4", "--width", "120")]
        [TestCase("film", "FILE", "--free", "--beats", "1", "--frames", "4", "--width", "120")]
        [TestCase("gallery", "monarch", "FILE", "--width", "200")]
        [TestCase("compare", "FILE", "monarch")]
        [TestCase("sweep", "flap-range", "100", "120", "--steps", "2", "--species", "FILE")]
        [TestCase("wind", "FILE", "--speeds", "0,3")]
        [TestCase("convergence", "FILE")]
        [TestCase("bake", "FILE", "--frames", "8")]
        [TestCase("bake", "FILE", "--frames", "8", "--format", "gltf-skin", "--variant", "flight")]
        [TestCase("wake", "FILE", "--speed", "0", "--pitch", "40")]
        [TestCase("wake", "FILE", "--free")]
        [TestCase("fly", "FILE", "--free", "--pilot", "wander", "--seconds", "2")]
        public void EveryCommandThatTakesASpecies_TakesTheFile(params string[] arguments)
        {
            using var run = new CommandRun();
            string[] named = arguments.Select(word => word == "FILE" ? File : word).ToArray();
            Assert.That(run.Run([.. named, "--out", run.Out]), Is.Zero, run.Errors);
            Assert.That(Directory.GetFiles(run.Out, "*", SearchOption.AllDirectories), Is.Not.Empty);
        }

        [Test, Explicit, Category("Long")]
        public void ASite_ShowsTheFilesInsect()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("site", run.Out, File), Is.Zero, run.Errors);
            Assert.That(System.IO.File.Exists(Path.Combine(run.Out, "insects", "hawkmoth-flight.json")), Is.True);
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void AFreeFlightOfTheFile_IsReplayed_WhereTheFileIsNamed()
        {
            using var run = new CommandRun();
            string record = Path.Combine(run.Folder, "flight.txt"), again = Path.Combine(run.Folder, "again");
            string[] plain = ["--no-pictures", "--out"];
            Assert.That(run.Run(["fly", File, "--free", "--seconds", "0.2", "--record", record, .. plain, run.Out]), Is.Zero, run.Errors);
            Assert.That(run.Run(["fly", File, "--free", "--replay", record, .. plain, again]), Is.Zero, run.Errors);
            Assert.That(System.IO.File.ReadAllBytes(Path.Combine(again, "trajectory.csv")),
                Is.EqualTo(System.IO.File.ReadAllBytes(Path.Combine(run.Out, "trajectory.csv"))));
            Assert.That(run.Run(["fly", "--free", "--replay", record, .. plain, again]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("hawkmoth"));
        }

        [Test]
        public void APage_KeepsTheFilesInsect_BesideThoseOfTheCatalogue()
        {
            InsectDefinition moth = KnownSpecies.Find(File);
            using var insect = new SceneInsect(ViewSettings.Of(moth, InsectVariant.Standard));
            foreach ((string message, InsectDefinition shown) in new[]
                {
                    ("""{"species":"monarch"}""", InsectCatalogue.Find("monarch")), ("""{"species":"hawkmoth"}""", moth),
                    ("""{"variant":"flight"}""", moth),
                })
            {
                insect.Change(ViewRequest.Read(System.Text.Encoding.UTF8.GetBytes(message)));
                Assert.That(insect.Settings.Flight.Definition, Is.SameAs(shown), message);
            }

            var path = ViewRequest.Read(System.Text.Encoding.UTF8.GetBytes(
                $$"""{"species":{{JsonSerializer.Serialize(File)}}}"""));
            Assert.That(() => insect.Change(path), Throws.TypeOf<UserException>().With.Message.StartsWith("Unknown species"),
                "A page opens no files.");
        }

        [Test]
        public void TwoInsectsOfOneName_AreRefused_WhereFilesAreNamedByThem()
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "monarch.insect.json");
            Assert.That(run.Run("species", "monarch", "--json", file), Is.Zero, run.Errors);
            Assert.That(run.Run("compare", "monarch", file, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("Two of these insects are called 'monarch'"));
        }

        [Test]
        public void AnInsectWhoseNumbersChanged_HasNoTrims_AndSaysHowToMakeThem()
        {
            using var run = new CommandRun();
            string text = System.IO.File.ReadAllText(File).Replace("1579", "1500");
            string trims = Path.Combine(Path.GetDirectoryName(File), "hawkmoth.trims");
            System.IO.File.Copy(trims, Path.Combine(run.Folder, "hawkmoth.trims"));
            Assert.That(run.Run("fly", run.Write("light.insect.json", text), "--free", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("no trim table for these numbers").And.Contain("trim --bake"));
        }
    }
}
