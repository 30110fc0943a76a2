using System;
using System.IO;
using System.Text;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Faults that are planted in a command: none is told as the user's, and nothing is left of its files.</summary>
public sealed class OwnErrorTests
{
    private const string k_Line =
        "alate: an error of Alate itself, not of your input: {0}: The number is not in the table. Please report it with the "
        + "command that you ran.";

    private static readonly Exception[] s_Own =
    [
        new ArgumentException("The number is not in the table."), new NotSupportedException("The number is\nnot in the table."),
        new InvalidOperationException("The number is not in the table"),
        new AggregateException("Two jobs failed.", new InvalidOperationException("The number is not in the table.")),
    ];

    [TestCaseSource(nameof(s_Own))]
    public void AFaultInACommand_IsOneLine_Ends70_AndLeavesTheFolderAsItWas(Exception planted)
    {
        using var folder = new TemporaryFolder();
        string before = folder.File("forces.csv", "before");
        var errors = new StringWriter();

        int code = Program.Run(Fly(folder), new FaultyOutput(planted), errors);

        Assert.That(code, Is.EqualTo(70), errors.ToString());
        Assert.That(errors.ToString(), Is.EqualTo(string.Format(k_Line, planted.GetBaseException().GetType().Name) + Environment.NewLine));
        Assert.That(folder.Content, Is.EqualTo(new[] { "forces.csv" }));
        Assert.That(File.ReadAllText(before), Is.EqualTo("before"));
    }

    [Test]
    public void TheStackTrace_IsPrinted_WhereItIsAskedFor()
    {
        using var folder = new TemporaryFolder();
        var errors = new StringWriter();

        int code = Program.Run(Fly(folder), new FaultyOutput(s_Own[0]), errors, isTraced: true);

        Assert.That(code, Is.EqualTo(70));
        Assert.That(errors.ToString(), Does.Contain("   at Alate.Cli.FlightReport."));
        Assert.That(folder.Content, Is.Empty);
    }

    [Test]
    public void TheSystemsAnswer_IsNoErrorOfOurs()
    {
        using var folder = new TemporaryFolder();
        var errors = new StringWriter();

        int code = Program.Run(Fly(folder), new FaultyOutput(new UnauthorizedAccessException("Access to the pipe is denied.")), errors);

        Assert.That(code, Is.EqualTo(2));
        Assert.That(errors.ToString(), Is.EqualTo("alate: Access to the pipe is denied." + Environment.NewLine));
        Assert.That(folder.Content, Is.Empty);
    }

    [Test]
    public void AFaultInAWriter_IsNotToldOfTheFolder_AndLeavesNothing()
    {
        using var temporary = new TemporaryFolder();
        using (var folder = OutputFolder.Prepare(temporary.PathOf("made"), "one.txt"))
        {
            foreach (Exception planted in s_Own)
                Assert.That(Assert.Catch(() => folder.Write("one.txt", _ => throw planted)), Is.SameAs(planted));
        }

        Assert.That(temporary.Content, Is.Empty);
    }

    [Test]
    public void AFaultInAReader_IsNotToldOfTheFile()
    {
        using var temporary = new TemporaryFolder();
        string file = temporary.File("wing.json", "{}");

        foreach (Exception planted in s_Own)
            Assert.That(Assert.Catch(() => TextFile.Read<int>(file, _ => throw planted)), Is.SameAs(planted));
    }

    [TestCase(""), TestCase(" "), TestCase("a\0b")]
    public void AFolderWithoutAName_IsTheUsers(string name)
    {
        UserException problem = Assert.Throws<UserException>(() => OutputFolder.Prepare(name, "one.txt"));

        Assert.That(problem.Message, Does.EndWith("that is no name of a folder."));
    }

    [TestCase(""), TestCase("a\0b")]
    public void AFileWithoutAName_IsTheUsers(string name)
    {
        Assert.That(Assert.Throws<UserException>(() => OutputFile.Write(name, _ => { })).Message, Does.EndWith("a file needs a name."));
        Assert.That(Assert.Throws<UserException>(() => InputFile.Open(name, 1)).Message, Does.EndWith("a file needs a name."));
    }

    private static string[] Fly(TemporaryFolder folder) => ["fly", "monarch", "--seconds", "0.2", "--no-pictures", "--out", folder.Root];

    // The report of a flight prints when its files are written and not yet named.
    private sealed class FaultyOutput(Exception planted) : TextWriter
    {
        public override Encoding Encoding => Encoding.UTF8;

        public override void Write(char value) => throw planted;

        public override void Write(char[] buffer, int index, int count) => throw planted;

        public override void Write(string value) => throw planted;
    }
}
