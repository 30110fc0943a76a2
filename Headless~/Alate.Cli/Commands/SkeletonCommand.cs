using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>skeleton</c>: makes skeletons for wings that have none.</summary>
internal static class SkeletonCommand
{
    public static Command Create(TextWriter output)
    {
        var command = new Command("skeleton", "Makes a skeleton for a wing that has none.");
        command.Subcommands.Add(SkeletonFitCommand.Create(output));
        command.Subcommands.Add(SkeletonFromImageCommand.Create(output));
        HelpExamples.Set(command, "Examples:\n  skeleton fit wing.obj --hinge 0,0,0\n  skeleton from-image wing.png");
        return command;
    }
}
