using System.CommandLine;

namespace Alate.Cli;

/// <summary>
/// The command line. Bad usage or input: one line on stderr and exit code 2. An error of the program's own: one line that asks for a
/// report, exit code 70. Ctrl-C: nothing is left behind, exit code 130.
/// </summary>
public static class Program
{
    /// <summary>Exit codes of bad usage or input, and of an error of the program's own (EX_SOFTWARE of sysexits.h).</summary>
    private const int k_BadInput = 2, k_OwnError = 70;

    /// <summary>Variable of the environment; <c>1</c> prints where an error of the program's own comes from.</summary>
    private const string k_Trace = "ALATE_TRACE";

    public static int Main(string[] args)
    {
        using IDisposable watch = Interruption.Watch();
        TextWriter output = Console.IsOutputRedirected ? new RedirectedOutput(Console.Out) : Console.Out;
        return Run(args, output, Console.Error, Environment.GetEnvironmentVariable(k_Trace) == "1");
    }

    /// <summary>Runs one command.</summary>
    /// <param name="args">Its words.</param>
    /// <param name="output">Standard output.</param>
    /// <param name="errors">Standard error.</param>
    /// <param name="isTraced">An error of the program's own is printed with its stack trace.</param>
    /// <returns>The exit code: 0 for success, 2 for bad usage or input, 70 for an error of the program's own.</returns>
    internal static int Run(string[] args, TextWriter output, TextWriter errors, bool isTraced = false)
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
        root.Subcommands.Add(StudyCommand.Create(output));
        root.Subcommands.Add(ConvergenceCommand.Create(output));
        root.Subcommands.Add(WindCommand.Create(output));
        root.Subcommands.Add(WakeCommand.Create(output));
        root.Subcommands.Add(ValidateCommand.Create(output));
        root.Subcommands.Add(InsectCommand.Create(output));
        root.Subcommands.Add(SkeletonCommand.Create(output));
        root.Subcommands.Add(BenchCommand.Create(output));
        root.Subcommands.Add(FiguresCommand.Create(output));
        root.Subcommands.Add(NewProjectCommand.Create(output));
        HelpExamples.AddTo(root);
        PackageVersion.AddTo(root);

        // A word is a word: @FILE is no list of more of them.
        ParseResult parsed = root.Parse(args.Length == 0 ? ["--help"] : args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (UsageProblem.Find(parsed) is string usage)
            return Fail(k_BadInput, usage, errors);
        try
        {
            using var held = HeldFolders.Begin();
            using var read = ReadFiles.Begin();
            int code = parsed.Invoke(
                new InvocationConfiguration { EnableDefaultExceptionHandler = false, Output = output, Error = errors });
            output.Flush();
            held.Commit();
            return code;
        }
        catch (UserException problem)
        {
            return Fail(k_BadInput, problem.Message, errors);
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            return Fail(k_BadInput, problem.Message, errors);
        }
        catch (Exception problem)
        {
            return Fail(k_OwnError, OwnError(problem.GetBaseException()), errors, isTraced ? problem.ToString() : null);
        }
    }

    private static string OwnError(Exception problem) =>
        $"an error of Alate itself, not of your input: {problem.GetType().Name}: {problem.Message.TrimEnd('.', ' ')}. "
        + "Please report it with the command that you ran.";

    private static int Fail(int code, string message, TextWriter errors, string trace = null)
    {
        try
        {
            errors.WriteLine("alate: " + QuotedMessage.Words(message.ReplaceLineEndings(" ").Trim()));
            if (trace != null)
                errors.WriteLine(trace);
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            // The line has no place to go to; the exit code is left.
        }

        return code;
    }
}
