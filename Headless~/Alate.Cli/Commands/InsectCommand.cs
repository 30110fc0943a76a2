using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>insect</c>: makes insects of the user's own.</summary>
internal static class InsectCommand
{
    public static Command Create(TextWriter output)
    {
        var command = new Command("insect", "Makes an insect of your own.");
        command.Subcommands.Add(InsectNewCommand.Create(output));
        HelpExamples.Set(command, "Examples:\n  insect new mymoth --wing wing.png --length 50mm --mass 1.6g --frequency 25Hz");
        return command;
    }
}
