using System;

namespace Alate.Proof
{
    /// <summary>Arguments of an editor's or a player's command line that a proof gives to it.</summary>
    internal static class ProofArguments
    {
        public const string Out = "-proofOut", Pipeline = "-proofPipeline", Pipelines = "-proofPipelines", Package = "-proofPackage";

        /// <summary>Command line of this process; tests give another.</summary>
        internal static string[] Line { get; set; } = Environment.GetCommandLineArgs();

        /// <summary>Value that follows a name on the command line of this process.</summary>
        /// <exception cref="ArgumentException">There is none; names it.</exception>
        public static string Value(string name) =>
            Find(Line, name) ?? throw new ArgumentException($"The command line has no {name}.");

        /// <summary>Value that follows a name in arguments; null where there is none.</summary>
        public static string Find(string[] arguments, string name)
        {
            int at = Array.IndexOf(arguments, name);
            return at >= 0 && at + 1 < arguments.Length ? arguments[at + 1] : null;
        }
    }
}
