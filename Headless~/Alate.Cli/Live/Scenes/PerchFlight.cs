using Alate.Flight;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// An insect of the catalogue that flies by its own wings, lands on a perch, sits, takes off and comes again: the components of a scene,
/// stepped as its viewer's time passes.
/// </summary>
internal sealed class PerchFlight : IDisposable
{
    /// <summary>Longest step, seconds, and the frame in which it is drawn.</summary>
    private const double k_Step = 0.01;

    private const float k_Frame = 1f / 60f;

    /// <summary>
    /// Seconds between a start and the next landing, seconds of a stay, and distance from which it is brought back, metres.
    /// </summary>
    private const float k_Flying = 1.5f, k_Staying = 6f, k_Lost = 6f;

    /// <summary>Distance between the perches of two pages, world units, and number of them before the places begin again.</summary>
    private const float k_Apart = 200f, k_Places = 64f;

    /// <summary>Frames in which an insect must have come to life.</summary>
    private const int k_MostFrames = 2000;

    /// <summary>Place where the insect comes from: height over the perch and distance behind it, metres.</summary>
    private const float k_Above = 0.25f, k_Behind = 0.7f;

    private readonly InsectWings m_Insect;
    private readonly InsectFlight m_Flight;
    private readonly PerchPilot m_Pilot;
    private readonly AbdomenSwing m_Abdomen;
    private readonly IReadOnlyList<RecordedWing> m_Wings;
    private readonly PerchSpot m_Spot;
    private float m_Since = k_Flying;

    /// <param name="definition">The insect.</param>
    /// <param name="wings">Its wings as the page knows them.</param>
    public PerchFlight(InsectDefinition definition, IReadOnlyList<RecordedWing> wings)
    {
        m_Wings = wings;
        var place = new Vector3(k_Apart * (PlayedScene.Enter() % k_Places), 0f, 0f);
        m_Spot = new PerchSpot { position = place, normal = new float3(0f, 1f, 0f), heading = 0f };
        try
        {
            m_Insect = InsectFactory.Create(definition, InsectVariant.Flight);
        }
        catch
        {
            PlayedScene.Leave();
            throw;
        }

        m_Insect.UpdateMode = WingUpdateMode.Manual;
        m_Insect.Quality.culling = WingCulling.AlwaysSimulate;
        m_Insect.transform.position = place + InsectDefinition.UnitsPerMetre * new Vector3(0f, k_Above, -k_Behind);
        m_Abdomen = m_Insect.GetComponentInChildren<AbdomenSwing>();
        m_Flight = CatalogueFlight.AddTo(m_Insect, definition);
        m_Pilot = m_Insect.gameObject.AddComponent<PerchPilot>();
        m_Pilot.Seed = 1;
        m_Pilot.Settings.stayTime = k_Staying;
        for (int frame = 0; frame < k_MostFrames && m_Insect.State != InsectState.Ready; frame++)
            PlayedScene.Tick(k_Frame);
        PlayedScene.Tick(k_Frame);
    }

    /// <summary>Simulated time, seconds.</summary>
    public double Time { get; private set; }

    /// <summary>State of the flight.</summary>
    public FlightState State => m_Flight.State;

    /// <summary>From the perch to the middle of the insect's thorax, metres: X right, Y up, Z ahead.</summary>
    public float3 Position => ((float3)m_Insect.transform.position - m_Spot.position) / InsectDefinition.UnitsPerMetre;

    /// <summary>Returns true for an insect that lands: one of the catalogue that flies in air.</summary>
    public static bool CanLand(InsectDefinition definition)
    {
        const float k_Dense = 100f;
        if (!InsectCatalogue.All.Contains(definition) || !definition.Variants.Contains(InsectVariant.Flight))
            return false;
        WingPreset preset = definition.Wings[0].CreatePreset(ModelReading.Physical, InsectVariant.Flight);
        bool isInAir = preset.Size.fluidDensity < k_Dense;
        UnityEngine.Object.DestroyImmediate(preset);
        return isInAir && CatalogueFlight.Flies(definition);
    }

    /// <summary>Lets time pass.</summary>
    public void Advance(double seconds)
    {
        int steps = (int)Math.Ceiling(seconds / k_Step);
        for (int k = 0; k < steps; k++)
        {
            float dt = (float)(seconds / steps);
            Choose(dt);
            m_Insect.Step(dt);
            PlayedScene.Tick(dt);
        }

        Time += seconds;
    }

    /// <summary>Adds the state: see the file format.js of the page.</summary>
    public void Write(StateBuffer buffer)
    {
        WingReading first = Read(0);
        float3 ahead = math.rotate(m_Insect.transform.rotation, new float3(0f, 0f, 1f)), force = (float3)m_Flight.Force;
        ahead = math.normalizesafe(new float3(ahead.x, 0f, ahead.z));
        buffer.Add((float)first.Phase);
        buffer.Add((uint)first.Beats);
        buffer.Add(first.Frequency);
        buffer.Add(force.y);
        buffer.Add(-math.dot(force, ahead));
        buffer.Add(0f);
        buffer.Add(AbdomenAngle());
        buffer.Add((uint)m_Wings[0].Parameters.substepsPerBeat);
        buffer.Add((uint)m_Wings.Count);
        for (int wing = 0; wing < m_Wings.Count; wing++)
            WriteWing(buffer, wing);
        quaternion turn = FileAxes.ToGltf((quaternion)m_Insect.transform.rotation);
        buffer.Add(FileAxes.ToGltf(Position));
        buffer.Add(turn.value.xyz);
        buffer.Add(turn.value.w);
        buffer.Add((uint)State);
    }

    private float AbdomenAngle()
    {
        if (m_Abdomen == null)
            return 0f;
        Quaternion turn = m_Abdomen.transform.localRotation;
        return 2f * math.atan2(turn.x, turn.w);
    }

    public void Dispose()
    {
        UnityEngine.Object.Destroy(m_Insect.gameObject);
        PlayedScene.Tick(k_Frame);
        PlayedScene.Leave();
    }

    private WingReading Read(int wing) => WingSystem.Loop.World.Read(m_Insect.Live.wings[wing].handle);

    // The pilot sits for its time and takes off by itself; where to land it is told.
    private void Choose(float dt)
    {
        m_Since = m_Pilot.Stage == PerchStage.Between ? m_Since + dt : 0f;
        if (math.length(Position) > k_Lost)
        {
            m_Insect.transform.position = (Vector3)m_Spot.position + InsectDefinition.UnitsPerMetre * new Vector3(0f, k_Above, -k_Behind);
            m_Insect.Teleport();
        }

        if (m_Since > k_Flying)
            m_Pilot.LandOn(m_Spot);
    }

    private void WriteWing(StateBuffer buffer, int wing)
    {
        RecordedWing recorded = m_Wings[wing];
        WingReading reading = Read(wing);
        int joints = reading.ChainCount * reading.JointsPerChain;
        float reach = 2f * (math.length(recorded.Placement.Hinge) + recorded.Placement.Length);
        buffer.Add((uint)recorded.Rest.Length);
        buffer.Add((uint)joints);
        buffer.Add(reach);
        buffer.Add(default(float3));
        for (int joint = 0; joint < joints; joint++)
        {
            buffer.Add(FileAxes.ToGltf(recorded.Placement.ToBody(
                reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain, 1f))));
        }
        for (int joint = 0; joint < joints; joint++)
            buffer.Add(default(float3));
        WriteMesh(buffer, m_Insect.Wings[wing].Renderer, recorded.Rest.Length, reach);
    }

    private void WriteMesh(StateBuffer buffer, Renderer renderer, int count, float reach)
    {
        Mesh mesh = renderer.GetComponent<MeshFilter>().sharedMesh;
        Vector3[] vertices = mesh.vertices, normals = mesh.normals;
        Transform wing = renderer.transform, root = m_Insect.transform;
        Span<short> places = buffer.Add<short>(4 * count);
        for (int k = 0; k < count; k++)
        {
            float3 body = (float3)root.InverseTransformPoint(wing.TransformPoint(vertices[k])) / InsectDefinition.UnitsPerMetre;
            float3 place = math.clamp(FileAxes.ToGltf(body) / reach, -1f, 1f) * short.MaxValue;
            (places[4 * k], places[4 * k + 1], places[4 * k + 2], places[4 * k + 3]) =
                ((short)math.round(place.x), (short)math.round(place.y), (short)math.round(place.z), 0);
        }

        Span<sbyte> packed = buffer.Add<sbyte>(4 * count);
        for (int k = 0; k < count; k++)
        {
            float3 normal = sbyte.MaxValue * FileAxes.Unit((float3)root.InverseTransformDirection(wing.TransformDirection(normals[k])));
            (packed[4 * k], packed[4 * k + 1], packed[4 * k + 2], packed[4 * k + 3]) =
                ((sbyte)normal.x, (sbyte)normal.y, (sbyte)normal.z, 0);
        }
    }
}
