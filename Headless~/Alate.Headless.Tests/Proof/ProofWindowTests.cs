using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Tests.Editor;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Proof;

/// <summary>The window that proves the package, as it is drawn.</summary>
public sealed class ProofWindowTests
{
    private EditorWindow m_Window;

    [SetUp]
    public void Open()
    {
        EditorMenu.Choose("Window/Alate/Proof");
        m_Window = OpenWindows.All.Single();
    }

    [TearDown]
    public void Close()
    {
        Object.DestroyImmediate(m_Window);
        OpenWindows.All.Clear();
    }

    [Test]
    public void ItTellsWhatItDoes_AndAsksForPipelinesAndAFolder()
    {
        var page = DrawnInspector.Of(DrawnInspector.Of(m_Window));
        Assert.That(page.HelpBoxes.Single(), Does.StartWith("Imports the package with all samples into new projects"));
        Assert.That(page.Controls.Where(control => control.Kind == ControlKind.Toggle).Select(choice => (choice.Text, choice.Value)),
            Is.EqualTo(new[] { ("builtin", "on"), ("urp", "off"), ("hdrp", "off") }));
        Assert.That(page.Control("Folder").Value, Does.EndWith(Path.DirectorySeparatorChar + "AlateProof"));
        Assert.That(page.Buttons, Has.Member("Prove").And.No.Member("Stop").And.No.Member("Show Report"));
    }

    // The editor is a script that leaves nothing: the first step ends, and the others are not tried.
    [Test]
    [Platform(Exclude = "Win")]
    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    public void AProof_ShowsItsStep_AndItsReportWhenItIsOver()
    {
        string folder = Directory.CreateTempSubdirectory("alate-window-").FullName;
        System.Action gui = DrawnInspector.Of(m_Window);
        try
        {
            (InstalledPackage.Folder, InstalledPackage.Version) = (PackageRoot.Find(), "4.5.6");
            (RunningEditor.Path, RunningEditor.Contents) = (Path.Combine(folder, "editor"), folder);
            File.WriteAllText(RunningEditor.Path, "#!/bin/sh\nexit 0\n");
            DrawnInspector.Put(gui, "Folder", Path.Combine(folder, "out"));
            DrawnInspector.Press(gui, "builtin");
            Assert.That(DrawnInspector.Press(gui, "Prove").HelpBoxes.Last(), Does.StartWith("No render pipeline is named"));
            DrawnInspector.Press(gui, "builtin");
            File.SetUnixFileMode(RunningEditor.Path, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            var page = DrawnInspector.Press(gui, "Prove");
            Assert.That(page.HelpBoxes.Count(), Is.EqualTo(1), "no problem any more");
            Assert.That(page.Buttons, Is.EqualTo(new[] { "Stop" }), "nothing else can be chosen meanwhile");
            DrawnControl bar = page.Controls.Single(control => control.Kind == ControlKind.Area);
            Assert.That((bar.Text, bar.Value, bar.Place.height), Is.EqualTo(("builtin: import", "0", 20f)));
            Assert.That(DrawnInspector.Press(gui, "Stop").Buttons, Has.Member("Prove"));

            DrawnInspector.Press(gui, "Prove");
            System.Action update = m_Window.GetType().GetMethod(
                "Update", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)
                .CreateDelegate<System.Action>(m_Window);
            Assert.That(System.Threading.SpinWait.SpinUntil(() =>
            {
                update();
                return DrawnInspector.Of(gui).Buttons.Contains("Prove");
            }, System.TimeSpan.FromSeconds(30)), Is.True);
            DrawnInspector.Press(gui, "Show Report");
            string report = Path.Combine(folder, "out", "report.md");
            Assert.That(AnsweredDialogs.Texts, Is.EqualTo(new[] { report }));
            Assert.That(File.ReadAllText(report), Does.StartWith("# Proof of Alate 4.5.6\n"));
            update();
            InstalledPackage.Folder = null;
            Assert.That(DrawnInspector.Press(gui, "Prove").Buttons, Has.No.Member("Show Report"));
        }
        finally
        {
            (InstalledPackage.Folder, RunningEditor.Path, RunningEditor.Contents) = (null, "", "");
            AnsweredDialogs.Clear();
            Directory.Delete(folder, true);
        }
    }

    [Test]
    public void AFolder_IsChosenInADialog_OrKept()
    {
        System.Action gui = DrawnInspector.Of(m_Window);
        string before = DrawnInspector.Of(gui).Control("Folder").Value;
        AnsweredDialogs.Answers.Enqueue("");
        Assert.That(DrawnInspector.Press(gui, "...").Control("Folder").Value, Is.EqualTo(before));
        AnsweredDialogs.Answers.Enqueue("/proofs");
        Assert.That(DrawnInspector.Press(gui, "...").Control("Folder").Value, Is.EqualTo("/proofs"));
        AnsweredDialogs.Clear();
    }

    [Test]
    public void WhereThePackageIsNotInstalledAsOne_ItSaysSo()
    {
        System.Action gui = DrawnInspector.Of(m_Window);
        DrawnInspector.Press(gui, "Prove");
        Assert.That(DrawnInspector.Of(gui).HelpBoxes.Last(), Is.EqualTo("The package is not installed as one: Proof needs its folder."));
    }
}
