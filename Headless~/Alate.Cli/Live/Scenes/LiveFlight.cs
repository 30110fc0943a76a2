namespace Alate.Cli;

/// <summary>An insect on the spot that is stepped as its viewer's time passes and tells how it is.</summary>
internal sealed class LiveFlight : IDisposable
{
    /// <summary>Largest of the whole numbers that stand for places.</summary>
    private const float k_Steps = short.MaxValue;

    /// <summary>Of the bytes that stand for stretches: 25.5 % at most.</summary>
    private const float k_StrainSteps = 1000f;

    /// <summary>
    /// Longest step that is made in one piece with a wake, beats: a step keeps twelve poses on its way, and a wake takes 24 a beat.
    /// </summary>
    private const double k_LongestPiece = 0.4;

    private readonly TetheredWings m_Wings;
    private readonly InsectAbdomen m_Abdomen;
    private readonly WingFields[] m_Fields;
    private readonly float3[][] m_Positions;
    private readonly float3[] m_Forces, m_Before;
    private double m_Stepped, m_Last;
    private int m_Pieces;
    private FlightPlan m_Plan;
    private LiveWake m_Wake;

    /// <exception cref="UserException">A parameter is out of range, or a mesh and its skeleton do not fit.</exception>
    public LiveFlight(FlightPlan plan, Insect insect)
    {
        m_Plan = plan;
        m_Wings = new TetheredWings(plan, insect);
        m_Abdomen = insect.Abdomen;
        m_Wings.RecordPatches();
        m_Fields = m_Wings.All.Select(wing => new WingFields(wing)).ToArray();
        m_Positions = m_Wings.All.Select(wing => new float3[wing.Rest.Length]).ToArray();
        m_Forces = new float3[m_Positions.Length];
        m_Before = new float3[m_Positions.Length];
    }

    public IReadOnlyList<RecordedWing> Wings => m_Wings.All;

    public ComparisonColumn Column => m_Plan.Column;

    /// <summary>Simulated time, seconds.</summary>
    public double Time { get; private set; }

    /// <summary>Hertz of this beat.</summary>
    public float Frequency => m_Wings.Read(0).Frequency;

    /// <summary>The wake; null where none is shown.</summary>
    public LiveWake Wake => m_Wake;

    /// <summary>Changes the flight from here on; a wake begins again.</summary>
    /// <exception cref="UserException">A parameter is out of range; the flight goes on as before.</exception>
    public void Change(FlightPlan plan)
    {
        if (plan == m_Plan)
            return;
        m_Wings.Change(plan);
        m_Plan = plan;
        m_Wake?.Restart(plan);
    }

    /// <summary>Shows a wake from here on, or none.</summary>
    /// <exception cref="UserException">A wing has no chord somewhere; none is shown.</exception>
    public void ShowWake(bool isShown)
    {
        if (isShown == (m_Wake != null))
            return;
        m_Wake?.Dispose();
        m_Wake = null;
        if (isShown)
            m_Wake = new LiveWake(m_Wings, m_Plan);
    }

    /// <summary>Lets time pass: whole substeps, as in a game, and between the last two what is drawn.</summary>
    public void Advance(double seconds)
    {
        Time += seconds;
        double substep = 1.0 / (Frequency * Wings[0].Parameters.substepsPerBeat);
        int count = (int)Math.Ceiling((Time - m_Stepped) / substep);
        if (count > 0)
            Step(count, substep);
        m_Wings.World.Skin(Alpha);
    }

    /// <summary>Adds the state: see the file format.js of the page.</summary>
    public void Write(StateBuffer buffer)
    {
        WingReading first = m_Wings.Read(0);
        (float lift, float drag) = LiftAndDrag();
        double turns = Turns(first), beats = Math.Floor(turns);
        buffer.Add((float)(2.0 * Math.PI * (turns - beats)));
        buffer.Add((uint)beats);
        buffer.Add(first.Frequency);
        buffer.Add(lift);
        buffer.Add(drag);
        buffer.Add(FlapOf(0));
        buffer.Add(AbdomenAt(turns, first));
        buffer.Add((uint)Wings[0].Parameters.substepsPerBeat);
        buffer.Add((uint)Wings.Count);
        for (int wing = 0; wing < Wings.Count; wing++)
            WriteWing(buffer, wing);
        m_Wake?.Write(buffer, turns, m_Positions);
    }

    public void Dispose()
    {
        m_Wake?.Dispose();
        m_Wings.Dispose();
    }

    private float Alpha => m_Last > 0.0 ? (float)Math.Clamp(1.0 - (m_Stepped - Time) / m_Last, 0.0, 1.0) : 1f;

    private float Weight => Wings[0].Wing.Preset.Size.insectMass * EarthGravity.Size;

    // Time that is drawn, beats.
    private double Turns(in WingReading first) =>
        Math.Max(first.Beats + first.Phase / (2.0 * Math.PI) - (m_Stepped - Time) * first.Frequency, 0.0);

    // In pieces whose poses are as close as a wake wants them; forces are the means over all of them.
    private void Step(int count, double substep)
    {
        int longest = m_Wake == null ? count : Math.Max((int)(k_LongestPiece * Wings[0].Parameters.substepsPerBeat), 1);
        bool isFirst = m_Stepped == 0.0;
        m_Forces.CopyTo(m_Before, 0);
        Array.Clear(m_Forces);
        m_Pieces = 0;
        for (int done = 0; done < count; m_Pieces++)
        {
            int piece = Math.Min(longest, count - done);
            m_Last = piece * substep;
            m_Wings.World.Step((float)m_Last);
            m_Stepped += m_Last;
            done += piece;
            for (int wing = 0; wing < m_Forces.Length; wing++)
                m_Forces[wing] += m_Wings.Read(wing).AirForce * ((float)piece / count);
            WingReading first = m_Wings.Read(0);
            m_Wake?.Follow(first.Beats + first.Phase / (2.0 * Math.PI), m_Last, first.Frequency);
        }

        if (isFirst)
            m_Forces.CopyTo(m_Before, 0);
    }

    // Between the last two steps, as what is drawn; what was stepped in pieces has one mean.
    private float3 AirForce(int wing) => m_Pieces > 1 ? m_Forces[wing] : math.lerp(m_Before[wing], m_Forces[wing], Alpha);

    // On the body, over the insect's weight.
    private float3 Force(int wing, float3 force)
    {
        PresetSize size = Wings[wing].Wing.Preset.Size;
        return Wings[wing].Placement.DirectionToBody(force) * (size.wingMass * size.wingLength / Weight);
    }

    private (float Lift, float Drag) LiftAndDrag()
    {
        float3 force = default, up = m_Plan.UpOfBody;
        for (int wing = 0; wing < Wings.Count; wing++)
            force += Force(wing, AirForce(wing));
        float3 ahead = math.cross(new float3(1f, 0f, 0f), up);
        return (math.dot(force, up), -math.dot(force, ahead));
    }

    // Angle of the line from hinge to tip above the horizontal, of what is drawn.
    private float FlapOf(int wing)
    {
        WingReading reading = m_Wings.Read(wing);
        float3 tip = reading.JointPosition(0, reading.JointsPerChain - 1, Alpha) - reading.JointPosition(0, 0, Alpha);
        return math.atan2(tip.y, math.length(tip.xz));
    }

    // Radians above where it does not swing.
    private float AbdomenAt(double turns, in WingReading reading) =>
        m_Abdomen?.AngleAt(turns, 2f * reading.Amplitude.x, Wings[0].Parameters) ?? 0f;

    private void WriteWing(StateBuffer buffer, int wing)
    {
        RecordedWing recorded = Wings[wing];
        WingMount placement = recorded.Placement;
        WingReading reading = m_Wings.Read(wing);
        int joints = reading.ChainCount * reading.JointsPerChain;
        float reach = 2f * (math.length(placement.Hinge) + placement.Length);
        var loads = new float3[joints];
        if (reading.HasPatchLoads)
            reading.AddJointLoads(loads);
        buffer.Add((uint)recorded.Rest.Length);
        buffer.Add((uint)joints);
        buffer.Add(reach);
        buffer.Add(FileAxes.ToGltf(Force(wing, AirForce(wing))));
        for (int joint = 0; joint < joints; joint++)
        {
            buffer.Add(FileAxes.ToGltf(
                placement.ToBody(reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain, Alpha))));
        }
        for (int joint = 0; joint < joints; joint++)
            buffer.Add(FileAxes.ToGltf(Force(wing, loads[joint])));
        WriteMesh(buffer, wing, reading, reach);
    }

    // Eight bytes a vertex: place, stretch and angle of attack; then four: normal.
    private void WriteMesh(StateBuffer buffer, int wing, in WingReading reading, float reach)
    {
        WingMount placement = Wings[wing].Placement;
        WingFrame frame = m_Wings.FrameOf(wing);
        Unity.Collections.NativeArray<SkinnedVertex> vertices = m_Wings.Vertices(wing);
        float3[] positions = m_Positions[wing];
        for (int k = 0; k < positions.Length; k++)
            positions[k] = frame.ToWing(vertices[k].position);
        float[] strain = m_Fields[wing].Strain(positions);
        Span<short> places = buffer.Add<short>(4 * positions.Length);
        for (int k = 0; k < positions.Length; k++)
        {
            float3 place = math.clamp(FileAxes.ToGltf(placement.ToBody(positions[k])) / reach, -1f, 1f) * k_Steps;
            (places[4 * k], places[4 * k + 1], places[4 * k + 2]) =
                ((short)math.round(place.x), (short)math.round(place.y), (short)math.round(place.z));
            int stretched = (int)math.clamp(k_StrainSteps * strain[k], 0f, 255f),
                attack = (int)math.degrees(m_Fields[wing].Attack(reading, k, positions));
            places[4 * k + 3] = (short)(stretched | (math.clamp(attack, 0, 90) << 8));
        }

        Span<sbyte> normals = buffer.Add<sbyte>(4 * positions.Length);
        for (int k = 0; k < positions.Length; k++)
        {
            float3 normal = sbyte.MaxValue * FileAxes.Unit(placement.DirectionToBody(frame.DirectionToWing(vertices[k].normal)));
            (normals[4 * k], normals[4 * k + 1], normals[4 * k + 2], normals[4 * k + 3]) =
                ((sbyte)normal.x, (sbyte)normal.y, (sbyte)normal.z, 0);
        }
    }
}
