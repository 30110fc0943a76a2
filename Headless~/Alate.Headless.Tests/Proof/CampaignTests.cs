using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.Versioning;
using System.Threading;
using Alate.Cli;
using Alate.Proof;
using NUnit.Framework;

namespace Alate.Tests.Proof;

/// <summary>A proof under way, with a script that stands for the editor.</summary>
[Platform(Exclude = "Win")]
[UnsupportedOSPlatform("windows")]
public sealed class CampaignTests
{
    private string m_Folder;

    [SetUp]
    public void MakeFolder() => m_Folder = Directory.CreateTempSubdirectory("alate-campaign-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(m_Folder, true);

    [Test]
    public void EachStep_StartsAnEditorOnce_InOneProjectAPipeline()
    {
        ProofReport report = Prove("builtin,urp", "printf '%s ' \"$@\" >>../../../calls; printf '\\n' >>../../../calls");

        // The script leaves no file of the import: nothing else is started.
        string[] calls = File.ReadAllLines(Path.Combine(m_Folder, "calls"));
        Assert.That(calls, Has.Length.EqualTo(2));
        Assert.That(calls[0], Does.Contain($"-projectPath {m_Folder}/out/builtin/project ").And.Contain("ProofSteps.Import"));
        Assert.That(calls[1], Does.Contain($"-projectPath {m_Folder}/out/urp/project "));
        Assert.That(report.Count(ProofState.Held) + report.Count(ProofState.Differs), Is.Zero);
        Assert.That(report.parts.Where(part => part.step == "golden").SelectMany(part => part.lines).Select(line => line.note),
            Is.All.EqualTo("the project was not imported"));
    }

    [Test]
    public void EveryStepsResult_IsReadFromItsFile()
    {
        string import = "{\"step\":\"import\",\"pipeline\":\"builtin\",\"editor\":\"Unity 6\",\"machine\":\"a PC\","
            + "\"lines\":[{\"what\":\"all samples import\",\"state\":1,\"measured\":\"7 scenes\"}]}";
        string tests = "<test-run total=\"3\" passed=\"2\" failed=\"1\" skipped=\"0\">"
            + "<test-case fullname=\"A.B\" result=\"Failed\"/></test-run>";
        ProofReport report = Prove("builtin", $$"""
            case "$*" in
                *ProofSteps.Import*) echo '{{import}}' >"$PWD/../import.json" ;;
                *EditMode*) echo '{{tests}}' >"$PWD/../edit-tests.xml" ;;
                *PlayMode*) echo 'No valid Unity Editor license found' >"$5"; exit 198 ;;
                *Golden*) exit 3 ;;
            esac
            """);

        Assert.That(Line(report, "import").state, Is.EqualTo(ProofState.Held));
        Assert.That(Line(report, "edit-tests").state, Is.EqualTo(ProofState.Differs));
        Assert.That(Line(report, "edit-tests").note, Is.EqualTo("1 failed, first A.B"));
        Assert.That(Line(report, "play-tests").note, Is.EqualTo("the editor has no licence on this machine"));
        Assert.That(Line(report, "golden").note, Is.EqualTo("the editor ended with code 3; see golden.log"));
        Assert.That(report.parts.Select(part => part.step), Is.EqualTo(ProofStep.All.Select(step => step.Name)));
        string text = File.ReadAllText(Path.Combine(m_Folder, "out", "report.md"));
        Assert.That(text, Does.Contain("Unity 6; a PC."));
        Assert.That(text, Does.Contain("| edit-tests | the package's tests pass | 🔴 **differs** | 2 of 3 passed"));
        Assert.That(File.Exists(Path.Combine(m_Folder, "out", "report.json")), Is.True);
    }

    [Test]
    public void TheProject_HasAllSamples_TestsOfThePackage_AndThePipelineOfThisEditor()
    {
        Prove("urp", "exit 0");
        string project = Path.Combine(m_Folder, "out", "urp", "project");
        string manifest = File.ReadAllText(Path.Combine(project, "Packages", "manifest.json"));
        Assert.That(manifest, Does.Contain("\"com.unity.render-pipelines.universal\": \"17.1.2\"")
            .And.Contain("\"testables\"").And.Contain($"\"file:{PackageRoot.Find()}\""));
        IEnumerable<string> samples = Scenes(Path.Combine(PackageRoot.Find(), "Samples~"));
        Assert.That(Scenes(Path.Combine(project, "Assets", "Samples")), Is.EquivalentTo(samples));
    }

    [Test]
    public void AnEditorThatIsStopped_Ends()
    {
        var campaign = new ProofCampaign(Options("builtin", "echo $$ >\"$3/../pid\"; sleep 60"));
        string pid = Path.Combine(m_Folder, "out", "builtin", "pid");
        campaign.Advance();
        SpinWait.SpinUntil(() => File.Exists(pid) && File.ReadAllText(pid).EndsWith('\n'), TimeSpan.FromSeconds(10));
        campaign.Dispose();
        Assert.That(() => System.Diagnostics.Process.GetProcessById(int.Parse(File.ReadAllText(pid))), Throws.ArgumentException);
    }

    [Test]
    public void ACampaign_TellsItsStepAndShare_OneAfterTheOther_AndItsSummaryAtTheEnd()
    {
        using var campaign = new ProofCampaign(Options("builtin", "exit 0"));
        var told = new List<string>();
        int steps = ProofStep.All.Length;
        do
        {
            int at = campaign.Report.parts.Count;
            Assert.That(campaign.Share, Is.EqualTo((float)at / steps).Within(1e-6f));
            if (told.LastOrDefault() != campaign.Status)
                told.Add(campaign.Status);
            Thread.Sleep(2);
        }
        while (campaign.Advance());
        Assert.That(told, Is.EqualTo(ProofStep.All.Select(step => $"builtin: {step.Name}")));
        Assert.That(campaign.Status, Is.EqualTo(campaign.Report.Summary));
        Assert.That((campaign.Advance(), campaign.Report.parts.Count), Is.EqualTo((false, steps)), "it is over");
        Assert.That(campaign.Report.package, Is.EqualTo("1.2.3"));
    }

    [Test]
    public void ResultsOfAnEarlierProof_AreNotTakenForThoseOfThisOne()
    {
        string folder = Path.Combine(m_Folder, "out", "builtin");
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, "edit-tests.xml"), "<test-run total=\"3\" passed=\"3\" failed=\"0\"/>");
        File.WriteAllText(Path.Combine(folder, "import.json"), "{\"lines\":[{\"what\":\"all samples import\",\"state\":1}]}");
        ProofReport report = Prove("builtin", "echo 'A.cs(1,2): error CS0103: no b' >\"$5\"");
        Assert.That(report.Count(ProofState.Held), Is.Zero);
        Assert.That(Line(report, "import").note, Is.EqualTo("A.cs(1,2): error CS0103: no b"));
        Assert.That(Line(report, "edit-tests").note, Is.EqualTo("the project was not imported"));
    }

    [Test]
    public void OptionsThatCannotBe_BeginNothing()
    {
        ProofOptions options = Options("builtin", "exit 0");
        options.Out = "";
        Assert.That(() => new ProofCampaign(options), Throws.ArgumentException.With.Message.EqualTo(options.FindProblem()));
    }

    private ProofReport Prove(string pipelines, string script)
    {
        using var campaign = new ProofCampaign(Options(pipelines, script));
        while (campaign.Advance())
            Thread.Sleep(5);
        Assert.That(campaign.Share, Is.EqualTo(1f));
        return campaign.Report;
    }

    private static IEnumerable<string> Scenes(string folder) =>
        Directory.GetFiles(folder, "*.unity", SearchOption.AllDirectories).Select(Path.GetFileName);

    private static ProofLine Line(ProofReport report, string step) => report.parts.Single(part => part.step == step).lines[0];

    private ProofOptions Options(string pipelines, string script)
    {
        string editor = Path.Combine(m_Folder, "editor"), contents = Path.Combine(m_Folder, "Data");
        File.WriteAllText(editor, $"#!/bin/sh\ncd \"$3\"\n{script}\n");
        File.SetUnixFileMode(editor, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        string package = Path.Combine(contents, "Resources/PackageManager/BuiltInPackages/com.unity.render-pipelines.universal");
        Directory.CreateDirectory(package);
        File.WriteAllText(Path.Combine(package, "package.json"), "{\"version\": \"17.1.2\"}");
        return new ProofOptions
        {
            Editor = editor,
            Contents = contents,
            Package = PackageRoot.Find(),
            Version = "1.2.3",
            Out = Path.Combine(m_Folder, "out"),
            Pipelines = pipelines.Split(','),
        };
    }
}
