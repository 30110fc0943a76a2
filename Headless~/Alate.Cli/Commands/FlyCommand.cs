using System.CommandLine;

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
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            if (free.IsFree(parsed))
            {
                options.CheckFree(parsed);
                FreePlan flown = free.Plan(parsed, parsed.GetValue(species), options.Seconds(parsed), options.Folder(parsed));
                FreeReport.Run(flown with { IsDrawn = options.IsDrawn(parsed) }, output);
                return 0;
            }

            FlightPlan plan = options.Plan(parsed, parsed.GetValue(species));
            FlightReport.Run(plan, output);
            return 0;
        });
        return command;
    }

    private const string k_Examples =
        "Examples:\n"
        + "  fly monarch\n"
        + "  fly firefly --variant biological\n"
        + "  fly monarch --speed 0.8 --climb 0.5 --pitch 30 --elasticity 0.5 --out climbing\n"
        + "  fly monarch --free --to 1,0.5,4 --gust 1,0,0 --seconds 12\n"
        + "  fly monarch --free --pilot wander --gust 0,-2,0 --record gust.txt\n"
        + "  fly --free --replay gust.txt\n"
        + "  fly dragonfly --kinematics Documentation~/kinematics/dragonfly-flight-1.json --speed 0.685 --climb -0.146\n"
        + "  fly dragonfly --kinematics Documentation~/kinematics/dragonfly-tethered.json --speed 0 --induced-flow 1.2\n"
        + "  fly --mesh wing.obj --skeleton wing.json --species monarch --texture photo.png --out mine\n"
        + "  fly --mesh fore.obj hind.obj --skeleton fore.json hind.json --species firefly\n\n"
        + "Writes into the output folder:\n"
        + "  strip.png     twelve phases of the last beat, seen from the side of --view\n"
        + "  stretch.png   the wings from above, in colours of the largest stretch of their membrane\n"
        + "  wings.glb     that beat as a looped 3D animation (glTF 2.0), metres\n"
        + "  forces.csv    force and moment of the air over that beat, N and N m\n"
        + "  joints.csv    every joint of the skeleton over that beat, metres\n"
        + "  summary.json  frequency, twist, camber, bend, lag, stretch, lift and cost\n"
        + "With --free: trajectory.csv, forces.csv, path.png (from above and from the side), flight.glb.\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
