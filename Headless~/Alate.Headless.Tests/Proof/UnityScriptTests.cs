using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Runtime.Versioning;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Proof;

/// <summary>The script <c>.ci/unity</c> with programs that stand for editors.</summary>
[Platform(Exclude = "Win")]
[UnsupportedOSPlatform("windows")]
public sealed class UnityScriptTests
{
    private string m_Folder;

    private string Out => Path.Combine(m_Folder, "out");

    [SetUp]
    public void MakeFolder() => m_Folder = Directory.CreateTempSubdirectory("alate-proof-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(m_Folder, true);

    [TestCase("Usage: .ci/unity EDITOR [--pipelines builtin,urp,hdrp] [--out DIR]")]
    [TestCase("There is no editor at '/no/editor'; give the path of Unity's program.", "/no/editor")]
    [TestCase("'vulkan' is no render pipeline; allowed are builtin, urp, hdrp.", "/bin/true", "--pipelines", "urp,vulkan")]
    [TestCase("Unknown option '--what'; allowed are --pipelines and --out.", "/bin/true", "--what", "x")]
    [TestCase("--out needs a value.", "/bin/true", "--out")]
    public void WrongInput_IsToldInOneLine(string expected, params string[] arguments) =>
        Assert.That(Run(arguments), Is.EqualTo((2, "", expected + "\n")));

    [Test]
    public void AnEditorWithoutALicence_IsToldInOneLine()
    {
        string editor = Editor("echo 'No valid Unity Editor license found. Please activate.' >\"$5\"; exit 198");
        (int code, string output, string error) = Run(editor, "--out", Out);
        Assert.That((code, output), Is.EqualTo((2, "")));
        Assert.That(error, Is.EqualTo("The editor has no licence on this machine: activate one in Unity Hub, or by -serial.\n"));
    }

    [Test]
    public void APackageThatDoesNotCompile_IsToldWithItsFirstError()
    {
        string editor = Editor("echo 'Runtime/A.cs(1,2): error CS0103: no b' >\"$5\"; exit 1");
        Assert.That(Run(editor, "--out", Out).error, Is.EqualTo("The package does not compile: Runtime/A.cs(1,2): error CS0103: no b\n"));
    }

    [Test]
    public void AnEditorThatLeavesNothing_IsToldWithItsCodeAndLog()
    {
        string editor = Editor("exit 7");
        Assert.That(Run(editor, "--out", Out).error,
            Is.EqualTo($"The editor ended with code 7 and left no report; see {Out}/start.log.\n"));
    }

    [Test]
    public void TheFirstEditor_IsStartedInAProjectWithThePackageAlone()
    {
        string editor = Editor("printf '%s\\n' \"$@\" >\"$5\"; printf '#\\n\\n1 held, 0 differ, 0 not tried.\\n' >\"${9}/report.md\"");
        (int code, string output, _) = Run(editor, "--out", Out, "--pipelines", "urp,hdrp");
        Assert.That((code, output), Is.EqualTo((0, $"1 held, 0 differ, 0 not tried.\n{Out}/report.md\n")));
        Assert.That(File.ReadAllLines(Path.Combine(Out, "start.log")), Is.EqualTo(new[]
        {
            "-batchmode", "-projectPath", $"{Out}/start", "-logFile", $"{Out}/start.log", "-executeMethod", "Alate.Proof.ProofCommand.Run",
            "-proofOut", Out, "-proofPackage", PackageRoot.Find(), "-proofPipelines", "urp,hdrp",
        }));
        string manifest = File.ReadAllText(Path.Combine(Out, "start", "Packages", "manifest.json"));
        Assert.That(manifest, Does.Contain($"\"com.alate.insect-wings\": \"file:{PackageRoot.Find()}\""));
    }

    private string Editor(string script)
    {
        string path = Path.Combine(m_Folder, "editor");
        File.WriteAllText(path, "#!/bin/sh\n" + script + "\n");
        File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        return path;
    }

    private (int code, string output, string error) Run(params string[] arguments)
    {
        var start = new ProcessStartInfo(Path.Combine(PackageRoot.Find(), ".ci", "unity"))
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = m_Folder,
        };
        arguments.ToList().ForEach(start.ArgumentList.Add);
        using var process = Process.Start(start);
        string output = process.StandardOutput.ReadToEnd(), error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output, error);
    }
}
