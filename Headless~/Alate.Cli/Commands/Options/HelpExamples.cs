using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.Runtime.CompilerServices;

namespace Alate.Cli;

/// <summary>Examples and remarks that follow a command's generated help.</summary>
internal static class HelpExamples
{
    private static readonly ConditionalWeakTable<Command, string> s_Texts = [];

    /// <summary>Says what to print below the help of a command.</summary>
    public static void Set(Command command, string text) => s_Texts.AddOrUpdate(command, text);

    /// <summary>Makes the help of the command and all below it print them.</summary>
    public static void AddTo(RootCommand root)
    {
        var examples = new List<string>();
        foreach (Command command in root.Subcommands)
        {
            if (s_Texts.TryGetValue(command, out string text))
                examples.Add(text.Split('\n')[1]);
        }

        Set(root, "Examples:\n" + string.Join('\n', examples));
        foreach (Option option in root.Options)
        {
            if (option is HelpOption { Action: HelpAction standard } help)
                help.Action = new HelpWithExamples(standard);
        }
    }

    /// <summary>Returns true where the user asks for help; the other arguments are then not checked.</summary>
    public static bool AreAskedFor(ParseResult parsed) => parsed.Action is HelpWithExamples;

    private sealed class HelpWithExamples(HelpAction standard) : SynchronousCommandLineAction
    {
        public override int Invoke(ParseResult parsed)
        {
            int code = standard.Invoke(parsed);
            if (s_Texts.TryGetValue(parsed.CommandResult.Command, out string text))
                parsed.InvocationConfiguration.Output.WriteLine(text);
            return code;
        }
    }
}
