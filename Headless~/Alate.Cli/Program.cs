using System;
using System.CommandLine;
using System.IO;

namespace Alate.Cli;

/// <summary>The command line. Bad usage or input: one line on stderr and exit code 2. Ctrl-C: nothing is left behind, exit code 130.</summary>
public static class Program
{
    public static int Main(string[] args)
    {
        using IDisposable watch = Interruption.Watch();
        return Run(args, Console.IsOutputRedirected ? new RedirectedOutput(Console.Out) : Console.Out, Console.Error);
    }

    /// <summary>Runs one command.</summary>
    /// <returns>The exit code: 0 for success, 2 for bad usage or input.</returns>
    internal static int Run(string[] args, TextWriter output, TextWriter errors)
    {
        var root = new RootCommand("Flies insects without Unity: pictures, a 3D file and numbers of wings that flex as they beat.");
        root.Subcommands.Add(FlyCommand.Create(output));
        root.Subcommands.Add(ViewCommand.Create(output));
        root.Subcommands.Add(SiteCommand.Create(output));
        root.Subcommands.Add(FilmCommand.Create(output));
        root.Subcommands.Add(TrimCommand.Create(output));
        root.Subcommands.Add(BakeCommand.Create(output));
        root.Subcommands.Add(GalleryCommand.Create(output));
        root.Subcommands.Add(SpeciesCommand.Create(output));
        root.Subcommands.Add(CompareCommand.Create(output));
        root.Subcommands.Add(SweepCommand.Create(output));
        root.Subcommands.Add(ConvergenceCommand.Create(output));
        root.Subcommands.Add(WindCommand.Create(output));
        root.Subcommands.Add(ValidateCommand.Create(output));
        root.Subcommands.Add(SkeletonCommand.Create(output));
        root.Subcommands.Add(BenchCommand.Create(output));
        root.Subcommands.Add(FiguresCommand.Create(output));
        root.Subcommands.Add(NewProjectCommand.Create(output));
        HelpExamples.AddTo(root);
        PackageVersion.AddTo(root);

        // A word is a word: @FILE is no list of more of them.
        ParseResult parsed = root.Parse(args.Length == 0 ? ["--help"] : args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (UsageProblem.Find(parsed) is string usage)
            return Fail(usage, errors);
        try
        {
            using var held = HeldFolders.Begin();
            int code = parsed.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false, Output = output, Error = errors });
            output.Flush();
            held.Commit();
            return code;
        }
        catch (UserException problem)
        {
            return Fail(problem.Message, errors);
        }
    }

    private static int Fail(string message, TextWriter errors)
    {
        try
        {
            errors.WriteLine("alate: " + Quote.Words(message.ReplaceLineEndings(" ").Trim()));
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            // The line has no place to go to; the exit code is left.
        }

        return 2;
    }
}
