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

    /// <summary>All commands, in the order of the help.</summary>
    internal static readonly (string Name, Func<TextWriter, Command> Create)[] s_Commands =
    [
        ("fly", FlyCommand.Create),
        ("view", ViewCommand.Create),
        ("site", SiteCommand.Create),
        ("film", FilmCommand.Create),
        ("trim", TrimCommand.Create),
        ("bake", BakeCommand.Create),
        ("gallery", GalleryCommand.Create),
        ("species", SpeciesCommand.Create),
        ("compare", CompareCommand.Create),
        ("sweep", SweepCommand.Create),
        ("study", StudyCommand.Create),
        ("convergence", ConvergenceCommand.Create),
        ("wind", WindCommand.Create),
        ("wake", WakeCommand.Create),
        ("validate", ValidateCommand.Create),
        ("insect", InsectCommand.Create),
        ("skeleton", SkeletonCommand.Create),
        ("bench", BenchCommand.Create),
        ("figures", FiguresCommand.Create),
        ("new-project", NewProjectCommand.Create),
    ];

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
        ParseResult parsed = Parse(args, output, args.Length == 0 ? null : args[0]);
        if (UsageProblem.Find(parsed) != null)
        {
            parsed = Parse(args, output, null);
            if (UsageProblem.Find(parsed) is string usage)
                return Fail(k_BadInput, usage, errors);
        }

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

    // The command of a name alone, where there is one: to make all of them takes longer than to start the program.
    private static ParseResult Parse(string[] args, TextWriter output, string name)
    {
        var root = new RootCommand("Flies insects without Unity: pictures, a 3D file and numbers of wings that flex as they beat.");
        bool isKnown = Array.Exists(s_Commands, command => command.Name == name);
        foreach ((string known, Func<TextWriter, Command> create) in s_Commands)
        {
            if (!isKnown || known == name)
                root.Subcommands.Add(create(output));
        }

        HelpExamples.AddTo(root);
        PackageVersion.AddTo(root);

        // A word is a word: @FILE is no list of more of them.
        return root.Parse(args.Length == 0 ? ["--help"] : args, new ParserConfiguration { ResponseFileTokenReplacer = null });
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
