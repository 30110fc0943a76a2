using Alate.Flight;

namespace Alate.Cli;

/// <summary>Forces, angles and powers of both strokes of a flight; degrees, shares in per cent.</summary>
/// <param name="DownImpulse">Upward impulse of the downstroke over that of the weight in the whole beat.</param>
/// <param name="UpForce">Share of the upstroke in the mean size of the force.</param>
/// <param name="DownAttack">Mean angle of attack in the middle of the downstroke.</param>
/// <param name="UpAttack">In the middle of the upstroke.</param>
/// <param name="Stored">Power of the wings where all that they give back is stored: that to the air, W/kg.</param>
/// <param name="Unstored">Power where nothing is stored: its positive part, W/kg.</param>
/// <param name="PitchBob">Half of the range of the pitch.</param>
internal sealed record HalfStrokes(
    double DownImpulse, double UpForce, double DownAttack, double UpAttack, double Stored, double Unstored, double PitchBob)
{
    private const int k_StepsPerBeat = 32;

    /// <summary>Beats and seconds until the flight is steady, and those of the means.</summary>
    private const int k_SettledBeats = 40, k_MeanBeats = 40;
    private const double k_Settled = 6, k_Means = 6;

    /// <summary>Distance from the middle of a stroke over which angles of attack are meant, beats.</summary>
    private const double k_Middle = 0.05;

    /// <summary>Of a level free flight by a species' trim table.</summary>
    /// <param name="species">Name.</param>
    /// <param name="speed">m/s.</param>
    /// <param name="substeps">Of a beat.</param>
    public static HalfStrokes Fly(string species, float speed, int substeps)
    {
        InsectDefinition insect = InsectCatalogue.Find(species);
        using FlightModel model = CatalogueFlight.CreateModel(insect);
        using TrimTable table = CatalogueFlight.CreateTable(insect, model);
        TrimmedFlight.Refine(model, _ => substeps);
        using var flight = new FreeFlight(model, table, new FlightCondition(speed, 0f));
        var command = FlightCommand.Fly(new float3(0f, 0f, speed), 0f);
        foreach (WingHandle wing in flight.Wings)
            flight.World.RecordPatches(wing, true);
        float step = 1f / (k_StepsPerBeat * flight.World.Read(flight.Wings[0]).Frequency);
        double settled = Math.Max(k_Settled, k_SettledBeats * k_StepsPerBeat * step),
            end = settled + Math.Max(k_Means, k_MeanBeats * k_StepsPerBeat * step);
        var moments = new List<FreeMoment>();
        var powers = new List<WingPower>();
        var down = new List<double>();
        var up = new List<double>();
        int beat = -1;
        while (flight.Time < end || flight.Beats == beat)
        {
            beat = flight.Beats;
            flight.Step(command, step);
            if (flight.Time < settled || (moments.Count == 0 && flight.Beats == beat))
                continue;
            moments.Add(FreeRun.Moment(flight));
            powers.AddRange(flight.Wings.Select((wing, k) =>
                WingPower.Of(flight.World.Read(wing), model.Wings[k].Mass, model.Wings[k].Length)));
            WingReading first = flight.World.Read(flight.Wings[0]);
            (Middle(first.Phase, 0.25) ? down : Middle(first.Phase, 0.75) ? up : null)?.Add(Attack(flight, model));
        }

        var means = FlightMeans.Of(model, moments, command.velocity);
        var power = WingPower.Mean(powers, moments.Count);
        return new HalfStrokes(100 * (1 - means.UpSupport) * means.Lift, 100 * means.UpForce, down.Average(), up.Average(),
            means.PowerPerMass, power.Positive / model.Mass, means.PitchBob);
    }

    /// <summary>Of a recorded beat on the spot, whose body is held still.</summary>
    /// <param name="flight">With recorded air.</param>
    /// <param name="weight">Of the insect, N.</param>
    public static HalfStrokes Of(FlightRecord flight, double weight)
    {
        RecordedWing first = flight.Wings[0];
        double downImpulse = 0, downForce = 0, upForce = 0, stored = 0, unstored = 0;
        var down = new List<double>();
        var up = new List<double>();
        for (int k = 0; k < first.Frames.Count; k++)
        {
            float3 force = 0f;
            double attack = 0, area = 0;
            foreach (RecordedWing wing in flight.Wings)
            {
                PresetSize size = wing.Wing.Preset.Size;
                double unit = size.wingMass * size.wingLength;
                force += (float)unit * wing.Placement.DirectionToBody(wing.Frames[k].AirForce);
                stored += wing.Frames[k].Power.Air;
                unstored += wing.Frames[k].Power.Positive;
                foreach (SpanStrip strip in wing.Frames[k].Strips.Where(strip => strip.Area > 0))
                {
                    double weighed = strip.Area * size.wingLength * size.wingLength;
                    attack += weighed * strip.Attack;
                    area += weighed;
                }
            }

            float3 world = flight.Plan.ToWorld(force);
            float phase = first.Frames[k].Phase;
            downImpulse += phase < Math.PI ? world.y : 0;
            downForce += phase < Math.PI ? math.length(force) : 0;
            upForce += phase < Math.PI ? 0 : math.length(force);
            (Middle(phase, 0.25) ? down : Middle(phase, 0.75) ? up : null)?.Add(math.degrees(attack / area));
        }

        int count = first.Frames.Count;
        double mass = weight / EarthGravity.Precise;
        return new HalfStrokes(100 * downImpulse / count / weight, 100 * upForce / (upForce + downForce), down.Average(), up.Average(),
            stored / count / mass, unstored / count / mass, 0);
    }

    private static bool Middle(double phase, double middle) => Math.Abs(phase / (2 * Math.PI) - middle) < k_Middle;

    // Over the area of all wings.
    private static double Attack(FreeFlight flight, FlightModel model)
    {
        double sum = 0, area = 0;
        for (int k = 0; k < flight.Wings.Count; k++)
        {
            WingReading wing = flight.World.Read(flight.Wings[k]);
            double unit = model.Wings[k].Length * model.Wings[k].Length;
            for (int patch = 0; patch < wing.PatchCount; patch++)
            {
                sum += unit * wing.PatchArea(patch) * wing.PatchAngleOfAttack(patch);
                area += unit * wing.PatchArea(patch);
            }
        }

        return math.degrees(sum / area);
    }
}
