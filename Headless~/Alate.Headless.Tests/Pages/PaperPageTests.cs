using System.IO;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Play;

/// <summary>The file and the study of the manual's page on papers.</summary>
public sealed class PaperPageTests
{
    private const string k_Page = "from-a-paper.md";

    [Test]
    public void TheFileOfThePage_CarriesAtLeastItsWeight_InAirAtRest()
    {
        using var run = new CommandRun();
        string file = run.Write("hawkmoth.insect.json", PageCode.Of(k_Page, "json")[0]);
        Assert.That(run.Run("fly", file, "--speed", "0", "--pitch", "40", "--substeps", "96", "--no-pictures", "--out", run.Out),
            Is.Zero, run.Errors);
        using var summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json")));
        Assert.That(summary.RootElement.GetProperty("lift_over_weight").GetDouble(), Is.EqualTo(1.1).Within(0.05));
    }

    [Test]
    public void TheStudyOfThePage_IsTheFilesStudy()
    {
        string study = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", "studies", "unknowns.study.json"));
        JsonNode told = JsonNode.Parse($"{{{PageCode.Of(k_Page, "json")[1]}}}")["parameters"];
        Assert.That(JsonNode.DeepEquals(JsonNode.Parse(study)["parameters"], told));
    }
}
