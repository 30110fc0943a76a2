using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Commands that write the manual, with made-up rows and files in place of minutes of flights.</summary>
public sealed class ReportCommandTests
{
    private static readonly ValidationRow s_Good = new("level", "largest twist", 1, 2, "1 to 2", "two animals", "a source", 1.5, 1.5),
        s_Bad = new("other", "lift", 1, 2, "1 to 2", "two animals", "a source", 3, 3),
        s_Third = new("third", "lift", 0, 1, "", "two animals", "", 0.5, 0.5);

    private static List<ValidationCurve> Curves() =>
        [new("twist", "twist", [("flexible", [0.0, 1.0, 0.0, -1.0])], [0, 2, 0, -2], "by somebody"),
            new("camber", "camber", [("flexible", [0.0, 0.5, 0.0, 0.0])], null)];

    private static Func<Action, IEnumerable<ValidationRow>> Part(params ValidationRow[] rows) => done =>
    {
        done();
        return rows;
    };

    [Test]
    public void Validation_WritesItsPageItsNumbersItsCharts_AndTheFrontPage()
    {
        using var run = new CommandRun();
        using var output = new StringWriter();
        string front = run.Write("front.md",
            "# A\r\n" + PageBlock.Begin("validation", "validate") + "old\n" + PageBlock.End("validation") + "\nrest\n");
        ValidateCommand.Run(null, run.Out, front, output, Curves, [Part(s_Good, s_Bad), Part(s_Third)]);

        ValidationRow[] rows = [s_Good, s_Bad, s_Third];
        Assert.That(Text(run, "validation.md"), Is.EqualTo(ValidationPage.Markdown(rows, Curves(), "images/validation.svg")));
        Assert.That(Text(run, "validation.json"), Is.EqualTo(ValidationJson.Write(rows, Curves())));
        Assert.That(Text(run, "images/validation.svg"), Is.EqualTo(ValidationCharts.Draw(Curves())));
        Assert.That(File.ReadAllText(front), Is.EqualTo("# A\n" + PageBlock.Begin("validation", "validate")
            + ValidationPage.Selection(rows) + PageBlock.End("validation") + "\nrest\n"));
        Assert.That(output.ToString(), Does.StartWith("2 of 3 counted rows agree.")
            .And.Contain("validation.md").And.Contain("validation.svg"));
    }

    [Test]
    public void CurvesOfAUser_TakeThePlaceOfThePublishedOnes_AndGetRows()
    {
        using var run = new CommandRun();
        using var output = new StringWriter();
        string data = Directory.CreateDirectory(Path.Combine(run.Folder, "data")).FullName;
        File.WriteAllText(Path.Combine(data, "twist.csv"), "0,0\n0.25,1\n0.5,0\n0.75,-1\n");
        ValidateCommand.Run(data, run.Out, null, output, Curves, [Part(s_Bad)]);

        List<ValidationCurve> curves = UserCurves.Read(data, Curves());
        Assert.That(Text(run, "validation.json"), Is.EqualTo(ValidationJson.Write([s_Bad, .. UserCurves.Rows(curves)], curves)));
        Assert.That(Text(run, "images/validation.svg"), Is.EqualTo(ValidationCharts.Draw(curves)));
        Assert.That(output.ToString(), Does.StartWith("0 of 1 counted rows agree."), "curves of one's own do not count");
    }

    [Test]
    public void AReportThatFails_LeavesNothing()
    {
        using var run = new CommandRun();
        string front = run.Write("front.md", PageBlock.Begin("validation", "validate") + PageBlock.End("validation"));
        string before = File.ReadAllText(front);

        Assert.That(() => ValidateCommand.Run(null, run.Out, front, TextWriter.Null, Curves,
            [Part(s_Good), _ => throw new UserException("no flight")]), Throws.TypeOf<UserException>());
        Assert.That(Directory.Exists(run.Out), Is.False);
        Assert.That(File.ReadAllText(front), Is.EqualTo(before));
    }

    [Test]
    public void Figures_AreAllWritten_OrNone()
    {
        using var run = new CommandRun();
        using var output = new StringWriter();
        FiguresCommand.Make(run.Out, ["a.txt", "images/b.txt"], output, 2, (folder, done, stage) =>
        {
            folder.Write("a.txt", stream => stream.WriteByte(65));
            stage("more");
            folder.Write("images/b.txt", stream => stream.WriteByte(66));
            done(2);
        });
        Assert.That((Text(run, "a.txt"), Text(run, "images/b.txt")), Is.EqualTo(("A", "B")));
        Assert.That(output.ToString(), Does.Contain(Path.Combine(run.Out, "a.txt")).And.Contain(Path.Combine(run.Out, "images/b.txt")));

        string other = Path.Combine(run.Folder, "other");
        Assert.That(() => FiguresCommand.Make(other, ["a.txt"], output, 1, (folder, _, _) =>
        {
            folder.Write("a.txt", stream => stream.WriteByte(65));
            throw new UserException("no");
        }), Throws.TypeOf<UserException>());
        Assert.That(Directory.Exists(other), Is.False);
    }

    [Test]
    public void NumbersOfThePage_AreOfEachVariant_AtItsCruise()
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        var told = new List<int>();
        List<FlightSummary> summaries = FiguresCommand.Measure([monarch], 12, told.Add);

        Assert.That(summaries.Select(summary => summary.Flight.Plan.Variant), Is.EqualTo(monarch.Variants));
        Assert.That(told, Is.EqualTo(Enumerable.Range(1, monarch.Variants.Count)));
        foreach (FlightSummary summary in summaries)
        {
            Assert.That((summary.Flight.Plan.Speed, summary.Flight.Wings[0].Frames.Count), Is.EqualTo((1.3, 12)));
            Assert.That(summary.Flight.Insect.Name, Is.EqualTo("monarch"));
        }
    }

    private static string Text(CommandRun run, string name) => File.ReadAllText(Path.Combine(run.Out, name));
}
