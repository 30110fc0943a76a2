using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Proof;
using NUnit.Framework;

namespace Alate.Tests.Proof;

/// <summary>The blank report on the page of the manual; <c>ALATE_WRITE_GOLDEN=1</c> writes it.</summary>
public sealed class ProofPageTests
{
    private static readonly Regex s_Report = new("(?<=<!-- report -->\n).*(?=\n<!-- end of report -->)", RegexOptions.Singleline);

    [Test]
    public void ThePage_ShowsTheReportOfAMachineWithoutAnEditor()
    {
        string path = Path.Combine(PackageRoot.Find(), "Documentation~", "proof.md"), page = File.ReadAllText(path);
        var report = new ProofReport();
        foreach (ProofStep step in ProofStep.All)
        {
            var part = new ProofPart { pipeline = ProofPipelines.BuiltIn, step = step.Name };
            part.lines.AddRange(step.Claims(PackageRoot.Find()).Select(claim => ProofLine.NotTried(claim)));
            report.parts.Add(part);
        }

        string text = report.Markdown(), table = text[text.IndexOf("| step |", StringComparison.Ordinal)..].TrimEnd('\n');
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_GOLDEN") == "1")
            File.WriteAllText(path, page = s_Report.Replace(page, table.Replace("$", "$$")));
        Assert.That(s_Report.Match(page).Value, Is.EqualTo(table));
    }
}
