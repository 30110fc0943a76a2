using System;
using System.CommandLine;
using Alate.Cli.Commands;

namespace Alate.Cli;

/// <summary>The command line. Bad usage or input: one line on stderr and exit code 2.</summary>
public static class Program
{
    public static int Main(string[] args)
    {
        var root = new RootCommand("Alate flies insects without Unity: pictures, a 3D file and numbers of wings that flex as they beat.");
        root.Subcommands.Add(FlyCommand.Create());
        root.Subcommands.Add(BenchCommand.Create());
        root.Subcommands.Add(NewProjectCommand.Create());

        ParseResult parsed = root.Parse(args);
        if (parsed.Errors.Count > 0)
            return Fail(parsed.Errors[0].Message);
        try
        {
            return parsed.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
        }
        catch (UserException problem)
        {
            return Fail(problem.Message);
        }
    }

    private static int Fail(string message)
    {
        Console.Error.WriteLine("alate: " + message.ReplaceLineEndings(" ").Trim());
        return 2;
    }
}
