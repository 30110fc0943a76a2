using Alate.Flight;

namespace Alate.Cli;

/// <summary>
/// Flight tables of the documentation's page of results: steady flights of all species, and the monarch's and the dragonfly's beside
/// measurements.
/// </summary>
internal static class FlightFigures
{
    /// <summary>The page, in the documentation's folder.</summary>
    public const string Page = "results.md";

    private const string k_Climbing = "Kang, Sridhar et al. 2020, a monarch that climbs by 0.75 m/s at 1.28 m/s",
        k_Halves = "Bode-Oke and Dong 2020, a monarch in forward flight",
        k_Dudley = "Dudley 1991, computed for 15 species of butterflies";

    private static readonly float[] s_Speeds = [0f, 0.65f, 1.3f, 2.3f];

    // Each trim begins at the one of the speed before.
    private static readonly float[] s_Approach = [0.3f, 0.65f, 1f, 1.3f, 1.6f, 2f];

    /// <summary>The page with its tables written again.</summary>
    public static string Make(string page)
    {
        page = PageBlock.Replace(page, "steady flights", MarkdownTable.Write(Steady(InsectCatalogue.All)));
        page = PageBlock.Replace(page, "flights beside measurements", MarkdownTable.Write(Measured()));
        return PageBlock.Replace(
            page, "the dragonfly beside measurements", MarkdownTable.Write(MeasuredDragonflies(MeasuredDragonfly.Flights)));
    }

    internal static IEnumerable<string[]> Steady(IEnumerable<InsectDefinition> insects)
    {
        yield return ["", "speed m/s", "pitch", "frequency Hz", "flap", "lift in the downstroke", "upstroke's share of the lift",
            "power W/kg"];
        foreach (InsectDefinition insect in insects.Where(insect => insect.Variants.Contains(InsectVariant.Flight)))
        {
            using FlightModel model = CatalogueFlight.CreateModel(insect);
            using TrimTable table = CatalogueFlight.CreateTable(insect, model);
            foreach (float speed in s_Speeds.Where(speed => !model.Floats && speed <= table?.TopSpeed))
            {
                var flight = FlightMeans.Fly(model, table, new FlightCondition(speed, 0f));
                yield return
                [
                    insect.DisplayName, Text($"{speed:0.##}"), Text($"{flight.Pitch:0} ± {flight.PitchBob:0}°"),
                    Text($"{flight.Frequency:0.0}"), Text($"{flight.Flap:0}°"),
                    Percent(flight.DownLift) + " of the weight", Percent(flight.UpSupport), Text($"{flight.PowerPerMass:0}"),
                ];
            }
        }
    }

    internal static IEnumerable<string[]> Measured()
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using FlightModel model = CatalogueFlight.CreateModel(monarch);
        using TrimTable table = CatalogueFlight.CreateTable(monarch, model);
        var level = FlightMeans.Fly(model, table, new FlightCondition(1.3f, 0f));
        TrimState climbing = FreeMonarch.MeasuredClimb(model, out string missing);
        string Climbing(Func<TrimState, double> radians) => climbing != null ? Text($"{180 / Math.PI * radians(climbing):0}°") : missing;
        yield return ["", "model, level at 1.3 m/s", "model, climbing by 0.75 m/s at 1.28 m/s", "measured", "source"];
        yield return ["mean pitch of the thorax", Text($"{level.Pitch:0}°"), Climbing(trim => trim.Pitch), "18.6°", k_Climbing];
        yield return ["bob of the pitch", Text($"±{level.PitchBob:0.0}°"),
            climbing != null ? Text($"±{180 / Math.PI * climbing.PitchBob:0.0}°") : "", "±8.3°", k_Climbing];
        yield return ["stroke plane off the vertical", "", climbing != null ? Climbing(trim => trim.Pitch + trim.Tilt) : "",
            "25.4°", k_Climbing];
        yield return ["upstroke's share of the force", Percent(level.UpForce), "", "32 %", k_Halves];
        yield return ["upstroke's share of the weight support", Percent(level.UpSupport), "", "8 %", k_Halves];
        yield return ["upward impulse of the downstroke over that of the weight in the beat", Percent(1 - level.UpSupport), "", "118 %",
            k_Dudley];
        yield return ["power to the air", Text($"{level.PowerPerMass:0} W/kg"), "", "12.5 W/kg", k_Dudley];
    }

    // Trims at the speeds and climbs of the flights in the tunnel.
    internal static IEnumerable<string[]> MeasuredDragonflies(IReadOnlyList<MeasuredDragonfly> flights)
    {
        InsectDefinition dragonfly = InsectCatalogue.Find("dragonfly");
        using FlightModel model = CatalogueFlight.CreateModel(dragonfly);
        using var solver = new TrimSolver(model);
        var bake = new TrimBake(model);
        yield return ["speed, climb, m/s", "", "frequency Hz", "flap of the fore wing", "of the hind wing", "stroke plane of the fore wing",
            "of the hind wing", "pitch of the body"];
        foreach (MeasuredDragonfly measured in flights)
        {
            IReadOnlyList<PresetKinematics> motion = DragonflyRun.Kinematics(measured);
            using var grid = new TrimTable(
                [.. s_Approach.Where(speed => speed < measured.Speed), (float)measured.Speed], [(float)measured.Climb]);
            TrimState trim = bake.Trims(solver, grid)[grid.Speeds.Length - 1, 0];
            string[] beat = [bake.Problem, "", "", "", "", ""];
            if (trim != null)
            {
                beat = Beat(trim.FrequencyScale * model.Frequency, Flaps(model, trim), Planes(model, trim),
                    Text($"{180 / Math.PI * trim.Pitch:0}°"));
            }
            yield return
            [
                Text($"{measured.Speed:0.0}, {measured.Climb:0.0#}"), "measured",
                .. Beat(motion[0].frequency, [.. motion.Select(wing => 2.0 * wing.flap.harmonics[0].x)],
                    [.. motion.Select(wing => 90.0 - wing.tilt.mean)], ""),
            ];
            yield return ["", "trim", .. beat];
        }
    }

    internal static string[] Beat(double frequency, double[] flaps, double[] planes, string pitch) =>
        [Text($"{frequency:0.0}"), Text($"{flaps[0]:0}°"), Text($"{flaps[1]:0}°"), Text($"{planes[0]:0}°"), Text($"{planes[1]:0}°"), pitch];

    internal static double[] Flaps(FlightModel model, TrimState trim) =>
        [.. RightWings(model).Select(wing => 360 / Math.PI * wing.Parameters.amplitude.x * trim.AmplitudeScale)];

    internal static double[] Planes(FlightModel model, TrimState trim) =>
        [.. RightWings(model).Select(wing => 90 - 180 / Math.PI * (wing.Parameters.tilt + trim.Tilt + trim.Pitch))];

    private static IEnumerable<FlightWing> RightWings(FlightModel model) => model.Wings.Where(wing => !wing.IsLeft);

    internal static string Percent(double share) => Text($"{100 * share + 0.0:0} %");

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
