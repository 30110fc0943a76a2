using Alate.Flight;

namespace Alate.Cli;

/// <summary>Flies a plan.</summary>
internal static class FreeRun
{
    /// <summary>Flies; tells the steps done.</summary>
    /// <exception cref="UserException">The insect does not fly.</exception>
    public static FreeRecord Fly(FreePlan plan, Action<int> progress)
    {
        using FlightModel model = plan.Replay?.CreateModel() ?? CatalogueFlight.CreateModel(plan.Insect);
        using TrimTable table = TrimmedFlight.TableOf(plan.Insect, model);
        FlightRecording recording = plan.Replay?.Recording ?? NewRecording(plan, model);
        using FreeFlight flight = recording.StartFlight(model, table);
        IFlightPilot pilot = plan.Replay == null ? plan.Pilot.Create(plan, table) : null;
        var moments = new List<FreeMoment>();
        var powers = new List<WingPower[]>();
        int push = 0;
        for (int step = 0; step < plan.Steps; step++)
        {
            if (pilot != null)
                recording.Steps.Add(Next(plan, flight, pilot));
            recording.Fly(flight, step, ref push);
            RecordedStep flown = recording.Steps[step];
            moments.Add(Moment(flight) with { Commanded = flown.velocity, CommandedHeading = flown.heading });
            powers.Add(Powers(flight, model));
            progress(step + 1);
        }

        return new FreeRecord(plan.Insect, moments, model.Centre, model.Weight, Beat(plan, model, moments))
        {
            Recording = recording,
            WingNames = Names(plan.Insect, model),
            Missing = FlightReach.Missing(table),
            Powers = powers,
        };
    }

    private static FlightRecording NewRecording(FreePlan plan, FlightModel model) => new()
    {
        Package = PackageRoot.Version,
        Insect = plan.Insect.Name,
        Key = model.Key,
        Options = plan.Options,
        Start = new FlightStart { settled = true },
    };

    private static RecordedStep Next(FreePlan plan, FreeFlight flight, IFlightPilot pilot)
    {
        bool gusts = flight.Time >= 0.5 * plan.Seconds && flight.Time < 0.5 * plan.Seconds + 1;
        return new RecordedStep(pilot.Command(flight.Situation((float)plan.Step)), (float)plan.Step, 1)
        {
            wind = gusts ? plan.Gust : default,
            gravity = flight.Gravity,
            aid = (float)plan.Aid,
            isUnguarded = !plan.GuardsCommands,
        };
    }

    /// <summary>A flight as it is after its last step.</summary>
    public static FreeMoment Moment(FreeFlight flight)
    {
        WingReading wing = flight.World.Read(flight.Wings[0]);
        return new FreeMoment(
            flight.Time, flight.Position, flight.Rotation, flight.Velocity, flight.AngularVelocity, flight.Reference.Velocity, flight.Wind,
            wing.Phase, wing.Frequency,
            wing.Amplitude.x, flight.Force, flight.Moment, flight.Power, flight.AidPower, flight.State);
    }

    // A scene may have its wings in another order: they are known by their sizes.
    private static List<string> Names(InsectDefinition insect, FlightModel model)
    {
        var kinds = new List<(string Name, PresetSize Size)>();
        foreach (WingDefinition wing in insect.Wings)
        {
            WingPreset preset = wing.CreatePreset(ModelReading.Physical, InsectVariant.Flight);
            kinds.Add((wing.Name, preset.Size));
            UnityEngine.Object.DestroyImmediate(preset);
        }

        return model.Wings.Select(wing => (wing.IsLeft ? "left " : "right ") + kinds.MinBy(kind =>
            Math.Abs(kind.Size.wingLength / wing.Length - 1f) + Math.Abs(kind.Size.wingMass / wing.Mass - 1f)).Name).ToList();
    }

    private static WingPower[] Powers(FreeFlight flight, FlightModel model) => Enumerable.Range(0, flight.Wings.Count)
        .Select(k => WingPower.Of(flight.World.Read(flight.Wings[k]), model.Wings[k].Mass, model.Wings[k].Length)).ToArray();

    // The beat of the flight's middle, on the spot: its shapes stand for those of the whole flight in pictures.
    private static FlightRecord Beat(FreePlan plan, FlightModel model, List<FreeMoment> moments)
    {
        FreeMoment middle = moments[moments.Count / 2];
        float3 ahead = math.rotate(middle.Rotation, new float3(0f, 0f, 1f));
        var beat = new FlightPlan
        {
            Definition = plan.Insect,
            Variant = InsectVariant.Flight,
            Speed = math.length(middle.Wanted.xz),
            Climb = middle.Wanted.y,
            PitchDegrees = math.degrees(math.asin(math.clamp(ahead.y, -1f, 1f))),
            Drive = new WingDrive
            {
                frequency = (float)middle.Frequency,
                amplitude = (float)(middle.Amplitude
                / model.Wings[0].Parameters.amplitude.x)
            },
        };
        return TetheredFlight.Fly(beat);
    }
}
