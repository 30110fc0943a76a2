using System.Diagnostics;
using System.Linq;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Play;

/// <summary>The program of the manual's page on console programs, built and run as the page says.</summary>
public sealed class ConsolePageTests
{
    [Test]
    [Explicit]
    [Category("Long")]
    public void TheProgramOfThePage_FliesAMonarch()
    {
        using var run = new CommandRun();
        run.Write("Insects.csproj", PageCode.Of("console.md", "xml").Single()
            .Replace("../com.alate.insect-wings", PackageRoot.Find()));
        run.Write("Program.cs", PageCode.Of("console.md").Single());
        var start = new ProcessStartInfo("dotnet", ["run"])
        {
            WorkingDirectory = run.Folder,
            RedirectStandardOutput = true,
        };
        using var process = Process.Start(start);
        string[] lines = process.StandardOutput.ReadToEnd().Trim().Split('\n');
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero, string.Join('\n', lines));
        Assert.That(lines[0].Trim(), Is.EqualTo("time_s,x_m,y_m,z_m,power_w,right_tip"));
        Assert.That(lines, Has.Length.InRange(251, 253));
        double[] last = [.. lines[^1].Split(',').Select(cell => double.Parse(cell, System.Globalization.CultureInfo.InvariantCulture))];
        Assert.That(last[3], Is.InRange(3.5, 5), "metres ahead after five seconds at one metre a second");
    }
}
