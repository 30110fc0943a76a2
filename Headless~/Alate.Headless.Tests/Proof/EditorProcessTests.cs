using System;
using System.Diagnostics;
using System.IO;
using System.Runtime.Versioning;
using System.Threading;
using Alate.Proof;
using NUnit.Framework;

namespace Alate.Tests.Proof;

/// <summary>An editor as a process: its arguments, its time and its end.</summary>
[Platform(Exclude = "Win")]
[UnsupportedOSPlatform("windows")]
public sealed class EditorProcessTests
{
    [Test]
    public void AnEditor_RunsUntilItsTimeIsOver([Values(-1, 60)] int minutes)
    {
        using var editor = new EditorProcess("/bin/sleep", ["30"], TimeSpan.FromMinutes(minutes));
        Assert.That(editor.HasEnded, Is.EqualTo(minutes < 0));
        Assert.That(editor.HasEnded, Is.EqualTo(minutes < 0), "and looked at again");
    }

    [Test]
    public void AnEditorThatEnds_HasItsCode_AndItsArgumentsAsTheyWereGiven()
    {
        string file = Path.GetTempFileName();
        try
        {
            using var editor = new EditorProcess(
                "/bin/sh", ["-c", "printf '%s|' \"$@\" >\"$0\"; exit 7", file, "one two", "-three", "\"four\""], TimeSpan.FromMinutes(60));
            Assert.That(SpinWait.SpinUntil(() => editor.HasEnded, TimeSpan.FromSeconds(20)), Is.True);
            Assert.That(editor.ExitCode, Is.EqualTo(7));
            Assert.That(File.ReadAllText(file), Is.EqualTo("one two|-three|\"four\"|"));
            Assert.That(editor.End, Throws.Nothing);
            Assert.That(editor.ExitCode, Is.EqualTo(7), "ended already");
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Test]
    public void AnEditorThatIsEnded_IsGone([Values] bool disposed)
    {
        string file = Path.GetTempFileName();
        var editor = new EditorProcess("/bin/sh", ["-c", "echo $$ >\"$0\"; exec sleep 30", file], TimeSpan.FromMinutes(60));
        SpinWait.SpinUntil(() => File.ReadAllText(file).EndsWith('\n'), TimeSpan.FromSeconds(20));
        int id = int.Parse(File.ReadAllText(file));
        File.Delete(file);
        if (disposed)
            editor.Dispose();
        else
            editor.End();
        Assert.That(() => Process.GetProcessById(id), Throws.ArgumentException);
        if (!disposed)
            editor.Dispose();
    }
}
