using System.CommandLine;

namespace Alate.Cli;

/// <summary>
/// <c>wake SPECIES</c>: flies an insect on the spot, lets its wings shed a free wake, and writes the loads with and without it.
/// </summary>
internal static class WakeCommand
{
    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect: {KnownSpecies.Names}. Not with --mesh.",
        };
        var flight = new FlyOptions();
        var options = new WakeOptions();
        var command = new Command("wake", "Computes the air that the wings of an insect leave behind, and its loads on them.") { species };
        options.AddTo(command);
        flight.AddBeatTo(command);
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            if (options.IsFree(parsed))
                flight.CheckTrimmed(parsed);
            FlightPlan plan = flight.Plan(parsed, parsed.GetValue(species));
            if (options.IsFree(parsed) && !flight.HasSpeed(parsed))
                plan = TrimmedFlight.WithinTable(plan);
            WakeReport.Run(plan, options.Plan(parsed), output);
            return 0;
        });
        return command;
    }

    private const string k_Examples =
        "Examples:\n"
        + "  wake monarch --variant flight --pitch 28\n"
        + "  wake dragonfly --kinematics Documentation~/kinematics/dragonfly-flight-2.json --speed 1.5 --coefficients dragonfly\n"
        + "  wake monarch --free --speed 1.3 --rounds 4\n"
        + "  wake dragonfly --method panels --steps 40 --ground 0.03\n\n"
        + "Writes into the output folder:\n"
        + "  wake.csv      force, moment and power of each wing over the last beat, and the force without the wake; N, W\n"
        + "  span.csv      circulation, force and moving air along the span of each wing over that beat, and span.svg\n"
        + "  inflow.json   mean and two harmonics of the air that the wake sets moving at each wing, m/s\n"
        + "  plane.csv     velocity and vorticity of the air in a plane behind the insect, mean of the last beat, and plane.svg\n"
        + "  wake.png      the insect at the end of its downstroke and the vortex rings of one and a half beats\n"
        + "  wake.glb      the beat with the rings that its wings leave, as a looped 3D animation (glTF 2.0), metres\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
