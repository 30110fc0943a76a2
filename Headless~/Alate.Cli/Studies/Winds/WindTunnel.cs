namespace Alate.Cli;

/// <summary>Measures one kind of wing in winds from all sides, which blow in one world.</summary>
internal sealed class WindTunnel : IDisposable
{
    private const int k_SettledBeats = 7;
    private const double k_SpinUpBeats = 1.0;

    private readonly FlightPlan m_Plan;
    private readonly InsectWing m_Wing;
    private readonly WingParameters m_Parameters;
    private readonly WingRig m_Rig;
    private readonly EdgeStretch m_Stretch;
    private readonly BeatMeasurement m_Measurement;

    /// <summary>Bakes the wing.</summary>
    /// <param name="plan">How it flies; its wind is replaced.</param>
    /// <param name="wing">The wing.</param>
    public WindTunnel(FlightPlan plan, InsectWing wing)
    {
        m_Plan = plan;
        m_Wing = wing;
        m_Parameters = plan.ParametersOf(wing.Preset);
        m_Rig = WingRig.Bake(wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = plan.Patches });
        float3[] rest = Array.ConvertAll(wing.Surface.positions, position => m_Rig.Frame.ToWing(position));
        m_Stretch = new EdgeStretch(rest, wing.Surface.triangles);
        m_Measurement = new BeatMeasurement(rest, wing.Surface.triangles);
    }

    /// <summary>Lets a wind blow from every side: over a settled beat where it is steady, from still air to still air in gusts.</summary>
    /// <param name="speed">m/s.</param>
    /// <param name="inGusts">See <see cref="GustProfile"/>.</param>
    public WindPoint Measure(double speed, bool inGusts)
    {
        using var world = new WingWorld();
        var samples = Sides(speed)
            .Select(side => new Sample(side, world.Add(m_Rig, m_Parameters, Surroundings(side, inGusts ? 0.0 : speed)))).ToList();
        int substeps = m_Parameters.substepsPerBeat;
        float step = 1f / (world.Read(samples[0].Wing).Frequency * substeps);
        int steps = substeps * (inGusts ? GustProfile.Beats : k_SettledBeats + 1);
        int first = inGusts ? (int)(k_SpinUpBeats * substeps) : steps - substeps;
        for (int k = 0; k < steps; k++)
        {
            if (inGusts)
                Blow(world, samples, speed * GustProfile.ShareAt((double)k / substeps));
            world.Step(step);
            if (k >= first)
                Record(world, samples);
        }

        return Result(speed, world, samples);
    }

    /// <summary>Frees the rig.</summary>
    public void Dispose() => m_Rig.Release();

    // Still air is the same from every side.
    private static IEnumerable<WindDirection> Sides(double speed) => speed > 0.0 ? WindDirection.All : [WindDirection.HeadWind];

    private WingSurroundings Surroundings(WindDirection side, double speed) =>
        (m_Plan with { Wind = side.Velocity(speed) }).SurroundingsOf(m_Wing.Preset, WingSide.Right);

    private void Blow(WingWorld world, List<Sample> samples, double speed)
    {
        foreach (Sample sample in samples)
            world.SetSurroundings(sample.Wing, Surroundings(sample.Side, speed));
    }

    private void Record(WingWorld world, List<Sample> samples)
    {
        world.Skin();
        foreach (Sample sample in samples)
        {
            float3[] positions = world.Vertices(sample.Wing).ToArray().Select(vertex => m_Rig.Frame.ToWing(vertex.position)).ToArray();
            float[] stretches = new float[m_Stretch.Count];
            m_Stretch.Measure(positions, stretches);
            sample.Stretches.AddRange(stretches);
            WingReading reading = world.Read(sample.Wing);
            float bend = m_Measurement.Bend(new BeatFrame(reading.Phase, reading.DrivenRotation(0, 0), positions));
            sample.Bend = math.max(sample.Bend, math.abs(bend));
        }
    }

    private static WindPoint Result(double speed, WingWorld world, List<Sample> samples)
    {
        Sample worst = samples.MaxBy(sample => sample.Stretches.Max());
        return new WindPoint(
            speed,
            100.0 * worst.Stretches.Max(),
            100.0 * samples.Max(sample => EdgeStretch.Percentile(sample.Stretches.ToArray(), 0.99f)),
            speed > 0.0 ? worst.Side : null,
            math.degrees(samples.First(sample => sample.Side == WindDirection.HeadWind).Bend),
            samples.Sum(sample => world.Read(sample.Wing).Resets));
    }

    // A wing, the side from which wind comes upon it, and what was seen of it.
    private sealed class Sample(WindDirection side, WingHandle wing)
    {
        public WindDirection Side { get; } = side;

        public WingHandle Wing { get; } = wing;

        /// <summary>Of all edges, frame by frame.</summary>
        public List<float> Stretches { get; } = [];

        /// <summary>Largest bend of the tip, radians.</summary>
        public float Bend { get; set; }
    }
}
