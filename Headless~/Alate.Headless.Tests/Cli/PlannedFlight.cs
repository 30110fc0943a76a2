using System.CommandLine;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>
    /// Flight of a typed command without the pictures and files that <c>fly</c> makes of it, which take thirty times as long.
    /// </summary>
    internal static class PlannedFlight
    {
        /// <summary>Flies what is typed after <c>fly</c>.</summary>
        public static FlightRecord Fly(params string[] arguments)
        {
            var species = new Argument<string>("SPECIES") { Arity = ArgumentArity.ZeroOrOne };
            var options = new FlyOptions();
            var command = new Command("fly") { species };
            options.AddTo(command);
            ParseResult parsed = command.Parse(arguments);
            Assert.That(parsed.Errors, Is.Empty);
            return TetheredFlight.Fly(options.Plan(parsed, parsed.GetValue(species)));
        }
    }
}
