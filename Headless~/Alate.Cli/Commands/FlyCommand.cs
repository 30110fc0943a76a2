using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Alate.Cli.Flights;

namespace Alate.Cli.Commands;

/// <summary><c>fly SPECIES</c>: simulates some beats and writes what came of it.</summary>
internal static class FlyCommand
{
    public static Command Create()
    {
        string known = string.Join(", ", Species.Names);
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect: {known}. With --mesh it may be left out.",
        };
        var mesh = new Option<string>("--mesh") { HelpName = "FILE.obj", Description = "A wing of your own, at rest; needs --skeleton and --species." };
        var skeleton = new Option<string>("--skeleton") { HelpName = "FILE.json", Description = "The skeleton of that wing, in its space." };
        var preset = new Option<string>("--species") { HelpName = "PRESET", Description = "Whose parameters that wing takes." };

        var speed = Numbers.Option("--speed", "M/S", 1.3, 0, 50, "Speed ahead, m/s.");
        var climb = Numbers.Option("--climb", "M/S", 0, 0, 50, "Speed up, m/s.");
        var pitch = Numbers.Option("--pitch", "DEG", 0, -90, 90, "Pitch of the body, degrees, nose up positive.");
        var seconds = Numbers.Optional("--seconds", "S", 0.01, 600, "Simulated time, s; at least two beats are flown. Default: 8 beats.");
        var wind = Numbers.Vector("--wind", "X,Y,Z", 100, "Wind in the world, m/s: right, up, ahead.");
        var lag = Numbers.Optional("--lag", "LAMBDA", 0, 2, "Delay of the trailing edge in half beats. Default: the species'.");
        var elasticity = Numbers.Option("--elasticity", "FACTOR", 1, 0.01, 100, "Factor on the species' elasticity k_e; below 1 is softer.");
        var substeps = Numbers.Optional("--substeps", "N", WingParameters.MinSubsteps, WingParameters.MaxSubsteps, "Substeps of a beat. Default: the species'.");
        var elements = new Option<string>("--elements")
        {
            HelpName = "triangles|N",
            DefaultValueFactory = _ => "256",
            Description = "What meets the air: every triangle, or about N patches.",
        };
        var coefficients = Choice<CoefficientSet?>("--coefficients", "Lift and drag coefficients. Default: the preset's.", new()
        {
            ["dickinson"] = CoefficientSet.Dickinson1999, ["paper"] = CoefficientSet.Paper, ["flatplate"] = CoefficientSet.FlatPlate,
        });
        var model = Choice<ModelPreset?>("--preset", "The equations as printed, or as resolved. Default: physical.", new()
        {
            ["paper"] = ModelPreset.Paper, ["physical"] = ModelPreset.Physical,
        });
        var noWave = new Option<bool>("--no-wave") { Description = "All chains beat at once: no deformation wave." };
        var rigid = new Option<bool>("--rigid") { Description = "The wing neither waves nor bends." };
        var output = new Option<string>("--out") { HelpName = "DIR", DefaultValueFactory = _ => "out", Description = "Where strip.svg, wings.glb, joints.csv and summary.json go." };

        var command = new Command("fly",
            "Flies an insect and writes pictures, a 3D file and numbers of its last beat.\n\n"
            + "Examples:\n"
            + "  fly monarch\n"
            + "  fly monarch --speed 0.6 --climb 0.8 --pitch 30 --elasticity 0.5 --out climbing\n"
            + "  fly --mesh wing.obj --skeleton wing.json --species monarch")
        {
            species, mesh, skeleton, preset, speed, climb, pitch, seconds, wind, lag, elasticity, substeps, elements, coefficients, model,
            noWave, rigid, output,
        };
        command.SetAction(parsed =>
        {
            var plan = new FlightPlan
            {
                Species = parsed.GetValue(species) ?? parsed.GetValue(preset),
                MeshFile = parsed.GetValue(mesh),
                SkeletonFile = parsed.GetValue(skeleton),
                Speed = parsed.GetValue(speed),
                Climb = parsed.GetValue(climb),
                PitchDegrees = parsed.GetValue(pitch),
                Seconds = parsed.GetValue(seconds),
                Wind = parsed.GetValue(wind),
                Lag = parsed.GetValue(lag),
                Elasticity = parsed.GetValue(elasticity),
                Substeps = (int?)parsed.GetValue(substeps),
                Patches = Patches(parsed.GetValue(elements)),
                Coefficients = parsed.GetValue(coefficients),
                Preset = parsed.GetValue(model) ?? ModelPreset.Physical,
                NoWave = parsed.GetValue(noWave),
                Rigid = parsed.GetValue(rigid),
            };
            if (parsed.GetValue(species) != null && parsed.GetValue(preset) != null)
                throw new UserException("Give the species once: as SPECIES, or as --species with --mesh.");
            FlightReport.Run(plan, parsed.GetValue(output));
            return 0;
        });
        return command;
    }

    private static int Patches(string text)
    {
        if (text == "triangles")
            return 0;
        if (int.TryParse(text, out int count) && count is >= 1 and <= 100000)
            return count;
        throw new UserException($"--elements takes 'triangles' or a number of patches from 1 to 100000, not '{text}'.");
    }

    private static Option<T> Choice<T>(string name, string description, Dictionary<string, T> values) => new(name)
    {
        Description = description,
        HelpName = string.Join("|", values.Keys),
        CustomParser = result =>
        {
            string text = result.Tokens.Count > 0 ? result.Tokens[0].Value : "";
            if (values.TryGetValue(text.ToLowerInvariant(), out T value))
                return value;
            result.AddError($"{name} takes {string.Join(", ", values.Keys.SkipLast(1))} or {values.Keys.Last()}, not '{text}'.");
            return default;
        },
    };
}
