using System.CommandLine;
using System.CommandLine.Parsing;

namespace Alate.Cli;

/// <summary><c>fly SPECIES</c>: simulates some beats and writes what came of the last one.</summary>
internal static class FlyCommand
{
    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect: {KnownSpecies.Names}. Not with --mesh.",
        };
        var options = new FlyOptions();
        var command = new Command("fly", "Flies an insect and writes pictures, a 3D file and numbers of its last beat.") { species };
        options.AddTo(command);
        var free = new FreeOptions();
        free.AddTo(command);
        var from = new Option<string>("--from")
        {
            HelpName = "FILE",
            Description = "A summary.json of a flight, which is flown again: the same insect, options and seeds. Takes --out alone.",
        };
        HelpExamples.Set(command, k_Examples);
        command.Options.Add(from);
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(from) is not string file)
            {
                Fly(parsed, null, options.Folder(parsed));
                return 0;
            }

            Option given = command.Options.FirstOrDefault(
                option => option != from && option != options.Out && parsed.GetResult(option) is { Implicit: false });
            if (given != null || parsed.GetValue(species) != null)
                throw new UserException($"--from takes no {given?.Name ?? "SPECIES"}: the file says it. --out is the folder of the files.");
            var run = FlownRun.Read(file);
            if (run.Version != PackageRoot.Version)
            {
                output.WriteLine(
                    $"Flown by version {Quote.Of(run.Version)[1..^1]}; this is {PackageRoot.Version}, whose numbers may differ.");
            }

            Fly(Parse(parsed, command, run, file, [from, options.Out, free.Record]), run, options.Folder(parsed));
            return 0;
        });
        return command;

        void Fly(ParseResult parsed, FlownRun run, string folder)
        {
            string name = parsed.GetValue(species);
            RunRecord record = run?.Record ?? new RunRecord(WordsOf(parsed, options.Out, free.Record));
            if (free.IsFree(parsed))
            {
                options.CheckFree(parsed);
                FreePlan flown = free.Plan(parsed, name, options.Seconds(parsed), folder, run?.Insect);
                FreeReport.Run(flown with { IsDrawn = options.IsDrawn(parsed), Record = record }, output);
            }
            else
            {
                FlightReport.Run(options.Plan(parsed, name, run?.Insect) with { Folder = folder, Record = record }, output);
            }
        }
    }

    // Without the options that say where files go.
    private static List<string> WordsOf(ParseResult parsed, params Option[] places)
    {
        var words = new List<string>();
        bool isPlace = false;
        foreach (Token token in parsed.Tokens)
        {
            if (token.Type == TokenType.Option)
                isPlace = Array.Exists(places, place => place.Name == token.Value);
            if (!isPlace)
                words.Add(token.Value);
            else if (token.Type != TokenType.Option)
                isPlace = false;
        }

        return words;
    }

    // The recorded words as if they had been typed; no file says where others are written.
    private static ParseResult Parse(ParseResult parsed, Command command, FlownRun run, string file, Option[] places)
    {
        ParseResult again = parsed.RootCommandResult.Command.Parse(
            run.Record.Command, new ParserConfiguration { ResponseFileTokenReplacer = null });
        bool isFlight = again.CommandResult.Command == command
            && !Array.Exists(places, place => again.GetResult(place) is { Implicit: false });
        string problem = isFlight ? UsageProblem.Find(again) : "it is no command of 'fly'.";
        return problem == null ? again : throw new UserException($"{file}: command: {problem}");
    }

    private const string k_Examples =
        "Examples:\n"
        + "  fly monarch\n"
        + "  fly firefly --variant biological\n"
        + "  fly monarch --speed 0.8 --climb 0.5 --pitch 30 --elasticity 0.5 --out climbing\n"
        + "  fly monarch --free --to 1,0.5,4 --gust 1,0,0 --seconds 12\n"
        + "  fly monarch --free --pilot wander --gust 0,-2,0 --record gust.txt\n"
        + "  fly --free --replay gust.txt\n"
        + "  fly --from out/monarch/summary.json --out again\n"
        + "  fly dragonfly --kinematics Documentation~/kinematics/dragonfly-flight-1.json --speed 0.685 --climb -0.146\n"
        + "  fly dragonfly --kinematics Documentation~/kinematics/dragonfly-tethered.json --speed 0 --induced-flow 1.2\n"
        + "  fly --mesh wing.obj --skeleton wing.json --species monarch --texture photo.png --out mine\n"
        + "  fly --mesh fore.obj hind.obj --skeleton fore.json hind.json --species firefly\n\n"
        + "Writes into the output folder:\n"
        + "  strip.png     twelve phases of the last beat, seen from the side of --view\n"
        + "  stretch.png   the wings from above, in colours of the largest stretch of their membrane\n"
        + "  wings.glb     that beat as a looped 3D animation (glTF 2.0), metres\n"
        + "  forces.csv    force and moment of the air and powers over that beat, N, N m and W\n"
        + "  spanwise.csv  lift, drag, moment and angle of attack over span and phase\n"
        + "  joints.csv    every joint of the skeleton over that beat, metres\n"
        + "  summary.json  frequency, twist, camber, bend, lag, stretch, lift, cost, and the whole run for --from\n"
        + "With --free: trajectory.csv, forces.csv, path.png (from above, height over distance, one beat's bob), flight.glb.\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
