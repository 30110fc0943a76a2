using Unity.Collections;

namespace Alate.Cli;

/// <summary>
/// The wings of an insect on the spot, right and left of each kind in turn: their rigs, their places, and the world that steps them.
/// </summary>
internal sealed class TetheredWings : IDisposable
{
    private readonly List<WingHandle> m_Handles = [];
    private readonly List<RecordedWing> m_Wings = [];
    private readonly List<WingFrame> m_Frames = [];
    private FlightPlan m_Plan;

    /// <summary>Bakes and places every wing; nothing has moved yet.</summary>
    /// <exception cref="UserException">A mesh and its skeleton do not fit, or a parameter is out of range.</exception>
    public TetheredWings(FlightPlan plan, Insect insect)
    {
        m_Plan = plan;
        try
        {
            foreach (InsectWing wing in insect.Wings)
                Add(wing);
        }
        catch
        {
            World.Dispose();
            throw;
        }
    }

    /// <summary>The world of these wings alone.</summary>
    public WingWorld World { get; } = new();

    /// <summary>[wing] Without frames; a flight adds them.</summary>
    public IReadOnlyList<RecordedWing> All => m_Wings;

    /// <summary>State of a wing at the end of the last step.</summary>
    public WingReading Read(int wing) => World.Read(m_Handles[wing]);

    /// <summary>Vertices that the last skinning made, mesh space.</summary>
    public NativeArray<SkinnedVertex> Vertices(int wing) => World.Vertices(m_Handles[wing]);

    /// <summary>Frame of a wing in its mesh.</summary>
    public WingFrame FrameOf(int wing) => m_Frames[wing];

    /// <summary>Keeps the loads of all patches from the next step on.</summary>
    public void RecordPatches() => m_Handles.ForEach(wing => World.RecordPatches(wing, true));

    /// <summary>Gives flying wings the numbers of another plan for the same insect; the beat goes on.</summary>
    /// <exception cref="UserException">A parameter is out of range; the wings keep theirs.</exception>
    public void Change(FlightPlan plan)
    {
        List<WingParameters> parameters = m_Wings.ConvertAll(wing =>
            plan.ParametersOf(wing.Wing.Preset, wing.Wing.Name, wing.Placement.Side));
        m_Plan = plan;
        for (int k = 0; k < m_Wings.Count; k++)
        {
            m_Wings[k].Parameters = parameters[k];
            World.SetParameters(m_Handles[k], parameters[k]);
            World.SetSurroundings(m_Handles[k], Surroundings(m_Wings[k].Wing, m_Wings[k].Placement));
        }
    }

    /// <summary>Values of a wing in the last step.</summary>
    /// <param name="wing">Its number.</param>
    /// <param name="time">Seconds since the start of the flight.</param>
    public RecordedFrame FrameOf(int wing, double time) => FrameOf(m_Wings[wing], Read(wing), Vertices(wing), m_Frames[wing], time);

    /// <summary>Frees the world and the rigs.</summary>
    public void Dispose() => World.Dispose();

    private WingSurroundings Surroundings(InsectWing wing, in WingMount placement)
    {
        WingSurroundings surroundings = m_Plan.SurroundingsOf(wing.Preset, placement.Side);
        surroundings.hinge = placement.Hinge / wing.Preset.WingLength;
        return surroundings;
    }

    private void Add(InsectWing wing)
    {
        WingRig rig = Bake(wing);
        float3[] rest = Array.ConvertAll(wing.Surface.positions, position => rig.Frame.ToWing(position));
        BeatMeasurement measurement = Measurement(rest, wing.Surface);
        foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
        {
            WingMount placement = wing.PlacementOf(rig.Frame, side);
            WingParameters parameters = m_Plan.ParametersOf(wing.Preset, wing.Name, side);
            m_Handles.Add(World.Add(rig, parameters, Surroundings(wing, placement)));
            if (m_Plan.Drive is WingDrive drive)
            {
                World.SetDrive(m_Handles[^1], drive);
                World.Reset(m_Handles[^1]);
            }

            WingReading start = World.Read(m_Handles[^1]);
            m_Frames.Add(rig.Frame);
            m_Wings.Add(new RecordedWing
            {
                Wing = wing,
                Placement = placement,
                Parameters = parameters,
                Rest = rest,
                Measurement = measurement,
                Triangles = wing.Surface.triangles,
                ChainCount = rig.ChainCount,
                JointsPerChain = rig.JointsPerChain,
                Stiffness = WingStiffness.Of(rig, start, wing.Preset.Size),
                Frequency = start.Frequency,
                Flap = wing.Preset.Kinematics.prescribed ? FlapOf(wing.Preset.Kinematics.flap) : 2f * start.Amplitude.x,
                IsMeshMirrored = rig.Frame.mirrored,
            });
        }

        rig.Release();
    }

    // From end to end.
    private static float FlapOf(in AngleSeries prescribed)
    {
        const int k_Places = 360;
        float least = float.MaxValue, most = float.MinValue;
        for (int k = 0; k < k_Places; k++)
        {
            float angle = prescribed.At((float)k / k_Places);
            (least, most) = (math.min(least, angle), math.max(most, angle));
        }

        return math.radians(most - least);
    }

    private WingRig Bake(InsectWing wing)
    {
        try
        {
            return WingRig.Bake(wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = m_Plan.Patches });
        }
        catch (ArgumentException problem)
        {
            throw new UserException(problem.Message);
        }
    }

    private static BeatMeasurement Measurement(float3[] rest, SurfaceMesh surface)
    {
        try
        {
            return new BeatMeasurement(rest, surface.triangles);
        }
        catch (ArgumentException problem)
        {
            throw new UserException($"Mesh '{surface.name}' cannot be measured: {problem.Message}");
        }
    }

    private static RecordedFrame FrameOf(
        RecordedWing wing, in WingReading reading, NativeArray<SkinnedVertex> vertices, in WingFrame frame, double time)
    {
        PresetSize size = wing.Wing.Preset.Size;
        int chains = reading.ChainCount, joints = reading.JointsPerChain;
        var recorded = new RecordedFrame
        {
            Time = time,
            Phase = reading.Phase,
            Root = reading.DrivenRotation(0, 0),
            AirForce = reading.AirForce,
            AirMoment = reading.AirMoment,
            NewtonIterations = reading.NewtonIterations,
            AirLoads = reading.HasPatchLoads ? new float3[chains * joints] : null,
            Attack = reading.HasPatchLoads ? Attack(reading) : 0f,
            Strips = reading.HasPatchLoads ? SpanStrip.Measure(reading, wing.Placement.Hinge / size.wingLength) : null,
            Power = WingPower.Of(reading, size.wingMass, size.wingLength),
            Positions = new float3[vertices.Length],
            Normals = new float3[vertices.Length],
            Joints = new float3[chains * joints],
            Bends = new float3[chains * (joints - 1)],
        };
        if (reading.HasPatchLoads)
            reading.AddJointLoads(recorded.AirLoads);
        for (int k = 0; k < vertices.Length; k++)
        {
            recorded.Positions[k] = frame.ToWing(vertices[k].position);
            recorded.Normals[k] = frame.DirectionToWing(vertices[k].normal);
        }

        for (int k = 0; k < recorded.Joints.Length; k++)
            recorded.Joints[k] = reading.JointPosition(k / joints, k % joints);
        for (int k = 0; k < recorded.Bends.Length; k++)
            recorded.Bends[k] = reading.BendAngles(k / (joints - 1), k % (joints - 1));
        return recorded;
    }

    // Of the patches that are 0.7 to 0.8 of a wing length away from the hinge.
    private static float Attack(in WingReading reading)
    {
        float sum = 0f;
        int count = 0;
        for (int patch = 0; patch < reading.PatchCount; patch++)
        {
            if (math.abs(math.length(reading.PatchPosition(patch)) - 0.75f) > 0.05f)
                continue;
            sum += reading.PatchAngleOfAttack(patch);
            count++;
        }

        return count > 0 ? sum / count : 0f;
    }
}
