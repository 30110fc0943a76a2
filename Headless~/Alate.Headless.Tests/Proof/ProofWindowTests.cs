using System.IO;
using System.Linq;
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

    [Test]
    public void WhereThePackageIsNotInstalledAsOne_ItSaysSo()
    {
        System.Action gui = DrawnInspector.Of(m_Window);
        DrawnInspector.Press(gui, "Prove");
        Assert.That(DrawnInspector.Of(gui).HelpBoxes.Last(), Is.EqualTo("The package is not installed as one: Proof needs its folder."));
    }
}
