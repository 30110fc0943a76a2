using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Proof;
using Alate.Showcase;
using NUnit.Framework;

namespace Alate.Tests.Proof;

/// <summary>Single steps of a proof: accounts of scenes, results of tests, projects, options and arguments.</summary>
public sealed class ProofStepLaws
{
    private string m_Folder;

    [SetUp]
    public void MakeFolder() => m_Folder = Directory.CreateTempSubdirectory("alate-steps-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(m_Folder, true);

    [TestCase(0, 4, 0, true, "")]
    [TestCase(1, 4, 0, false, "no shader")]
    [TestCase(0, 3, 0, false, "no shader")]
    [TestCase(0, 5, 0, false, "no shader")]
    [TestCase(0, 4, 1, false, "1 of 4 pictures show one colour")]
    [TestCase(2, 4, 4, false, "4 of 4 pictures show one colour")]
    public void AScene_Holds_WithAllItsPictures_NoneBlank_AndNoError(int errors, int pictures, int blank, bool held, string note)
    {
        new SceneAccount
        {
            frames = 600,
            milliseconds = 16.68f,
            errors = errors,
            firstError = held ? "" : "no shader",
            pictures = pictures,
            blank = blank,
        }.Write(m_Folder, "Garden");
        ProofLine line = SceneTour.Line(m_Folder, "Garden", "it plays");

        Assert.That((line.what, line.state == ProofState.Held, line.state == ProofState.Differs), Is.EqualTo(("it plays", held, !held)));
        Assert.That((line.measured, line.allowed, line.note), Is.EqualTo(($"600 frames of 16.7 ms, {errors} errors", "0 errors", note)));
    }

    [Test]
    public void ASceneWithoutAnAccount_DidNotEndInTime()
    {
        ProofLine line = SceneTour.Line(m_Folder, "Garden", "it plays");
        Assert.That((line.state, line.measured, line.note),
            Is.EqualTo((ProofState.Differs, "no report", "it did not end within 120 s")));
        Assert.That(SceneTour.Times, Is.Ordered.And.All.Positive);
        Assert.That(SceneTour.Claim("Garden"), Is.EqualTo($"Garden plays for {SceneTour.Times[^1]:0} s without an error"));
    }

    [TestCase("<test-run total=\"7\" passed=\"5\" failed=\"0\" skipped=\"2\"/>", true, "5 of 7 passed, 2 skipped", "")]
    [TestCase("<test-run total=\"2\" passed=\"0\" failed=\"0\" skipped=\"2\"/>", false, "0 of 2 passed, 2 skipped", "")]
    [TestCase("<test-run total=\"1\" passed=\"1\" failed=\"0\" skipped=\"0\"/>", true, "1 of 1 passed, 0 skipped", "")]
    [TestCase("<test-run total=\"3\" passed=\"1\" failed=\"2\" skipped=\"0\"><a><test-case fullname=\"A\" result=\"Passed\"/>"
        + "<test-case fullname=\"B\" result=\"Failed\"/><test-case fullname=\"C\" result=\"Failed\"/></a></test-run>", false,
        "1 of 3 passed, 0 skipped", "2 failed, first B")]
    [TestCase("<test-run/>", false, "0 of 0 passed, 0 skipped", "")]
    public void Tests_Hold_WhereSomePassAndNoneFails(string text, bool held, string measured, string note)
    {
        string path = Path.Combine(m_Folder, "tests.xml");
        Assert.That(TestResults.Read(path), Is.Null);
        File.WriteAllText(path, text);
        ProofLine line = TestResults.Read(path);
        Assert.That((line.what, line.state == ProofState.Held, line.measured, line.allowed, line.note),
            Is.EqualTo((TestResults.Claim, held, measured, "0 failed", note)));
        File.WriteAllText(path, text[..^2]);
        Assert.That((TestResults.Read(path).measured, TestResults.Read(path).state), Is.EqualTo(("no results", ProofState.Differs)));
    }

    [Test]
    public void AProject_IsMadeAnew_ButForItsLibrary()
    {
        ProofOptions options = Options();
        string project = ProofProject.Make(options, "builtin");
        Assert.That(project, Is.EqualTo(Path.Combine(m_Folder, "out", "builtin", "project")));
        Dictionary<string, string> made = Files(project);
        foreach (string folder in new[] { "Assets", "Packages", "ProjectSettings", "Library" })
        {
            Directory.CreateDirectory(Path.Combine(project, folder));
            File.WriteAllText(Path.Combine(project, folder, "old.txt"), "");
        }

        Assert.That(ProofProject.Make(options, "builtin"), Is.EqualTo(project));
        Dictionary<string, string> again = Files(project);
        Assert.That(again.Keys.Except(made.Keys), Is.EqualTo(new[] { Path.Combine("Library", "old.txt") }));
        Assert.That(made.All(file => again[file.Key] == file.Value), Is.True);
        string samples = Path.Combine(PackageRoot.Find(), "Samples~");
        Assert.That(made.Keys.Where(file => file.StartsWith("Assets", StringComparison.Ordinal))
            .Select(file => file[("Assets/Samples/".Length)..]),
            Is.EquivalentTo(Files(samples).Keys));
        Assert.That(Directory.Exists(Path.Combine(project, "ProjectSettings")), Is.True);
    }

    [Test]
    public void AManifest_IsThatOfThePackage_WithItsPath_AndThePipelineOfTheEditor()
    {
        string own = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Packages", "manifest.json"));
        string plain = Manifest("builtin"), universal = Manifest("urp");
        Assert.That(plain, Is.EqualTo(own.Replace("\"file:..\"", $"\"file:{PackageRoot.Find()}\"")));
        const string k_Added = "\n    \"com.unity.render-pipelines.universal\": \"17.1.2\",";
        Assert.That(universal.Replace(k_Added, ""), Is.EqualTo(plain));
        Assert.That(universal.IndexOf(k_Added, StringComparison.Ordinal),
            Is.EqualTo(plain.IndexOf("\"dependencies\": {", StringComparison.Ordinal) + "\"dependencies\": {".Length));

        string Manifest(string pipeline) =>
            File.ReadAllText(Path.Combine(ProofProject.Make(Options(), pipeline), "Packages", "manifest.json"));
    }

    [Test]
    public void AnEditorOnAMac_IsAFolder_WithItsProgramInside()
    {
        Assert.That(ProofOptions.ProgramOf(m_Folder), Is.EqualTo(Path.Combine(m_Folder, "Contents", "MacOS", "Unity")));
        Assert.That(ProofOptions.ProgramOf(m_Folder + "/Unity"), Is.EqualTo(m_Folder + "/Unity"));
    }

    [Test]
    public void EachPipeline_HasItsPackage_AndOthersAreTold()
    {
        Assert.That(ProofPipelines.All.Select(ProofPipelines.PackageOf), Is.EqualTo(new[]
        {
            null, "com.unity.render-pipelines.universal", "com.unity.render-pipelines.high-definition",
        }));
        Assert.That(() => ProofPipelines.PackageOf("gl"),
            Throws.ArgumentException.With.Message.EqualTo("'gl' is no render pipeline; allowed are builtin, urp, hdrp."));
        Assert.That(ProofPipelines.VersionIn(m_Folder, "none"), Is.Null);
    }

    [Test]
    public void AValueOfTheCommandLine_FollowsItsName()
    {
        string[] line = ["-a", "1", "-b", "-c", "3", "-d"];
        Assert.That(new[] { "-a", "-b", "-c", "-d", "-e" }.Select(name => ProofArguments.Find(line, name)),
            Is.EqualTo(new[] { "1", "-c", "3", null, null }));
    }

    [Test]
    public void AStep_WritesItsLogAndItsResultIntoTheFolderOfItsPipeline()
    {
        ProofOptions options = Options();
        foreach (ProofStep step in ProofStep.All)
        {
            List<string> arguments = [.. step.Arguments("/project", options, "urp")];
            string folder = Path.Combine(options.Out, "urp");
            Assert.That(arguments.Take(5), Is.EqualTo(
                new[] { "-batchmode", "-projectPath", "/project", "-logFile", Path.Combine(folder, step.Name + ".log") }));
            string result = Path.Combine(folder, step.Name + (step.IsTests ? ".xml" : ".json"));
            Assert.That(step.ResultIn(options.Out, "urp"), Is.EqualTo(result));
            Assert.That(arguments.Contains("-runTests"), Is.EqualTo(step.IsTests));
            Assert.That(ProofArguments.Find([.. arguments], "-testResults"), Is.EqualTo(step.IsTests ? result : null));
            Assert.That(ProofArguments.Find([.. arguments], ProofArguments.Package), Is.EqualTo(step.IsTests ? null : options.Package));
            Assert.That(arguments.Contains("--burst-force-sync-compilation"),
                Is.EqualTo(!step.IsTests), "times are those of compiled jobs");
            Assert.That(step.Claims(PackageRoot.Find()), Is.Unique.And.Not.Empty);
        }
    }

    private static Dictionary<string, string> Files(string folder) => Directory.GetFiles(folder, "*", SearchOption.AllDirectories)
        .ToDictionary(file => Path.GetRelativePath(folder, file), file => Convert.ToHexString(
            System.Security.Cryptography.SHA256.HashData(File.ReadAllBytes(file))));

    private ProofOptions Options()
    {
        string package = Path.Combine(m_Folder, "Data/Resources/PackageManager/BuiltInPackages/com.unity.render-pipelines.universal");
        Directory.CreateDirectory(package);
        File.WriteAllText(Path.Combine(package, "package.json"), "{\"version\": \"17.1.2\"}");
        return new ProofOptions
        {
            Contents = Path.Combine(m_Folder, "Data"),
            Package = PackageRoot.Find(),
            Out = Path.Combine(m_Folder, "out"),
        };
    }
}
