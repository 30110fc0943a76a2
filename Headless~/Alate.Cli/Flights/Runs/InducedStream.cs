namespace Alate.Cli;

/// <summary>
/// Finds the induced flow of a flight on the spot beat by beat: its momentum is what the mean force of the beat gives to the air, through
/// the sectors that the leading edges of a pair of wings sweep, a mean over fore and hind pair.
/// </summary>
internal sealed class InducedStream
{
    /// <summary>Places within a step between which a leading edge sweeps triangles.</summary>
    private const int k_Places = 12;

    /// <summary>
    /// Bounds of the share of the way to the velocity that the last beat asks for, and the first one: the force falls as the speed rises.
    /// </summary>
    private const float k_LeastShare = 0.05f, k_MostShare = 1f, k_FirstShare = 0.5f;

    private readonly FlightPlan m_Plan;
    private readonly TetheredWings m_Wings;
    private float3 m_Force, m_Lack;
    private float m_Share = k_FirstShare;
    private double m_Swept;
    private int m_Substeps;

    public InducedStream(FlightPlan plan, TetheredWings wings)
    {
        m_Plan = plan;
        m_Wings = wings;
    }

    /// <summary>Velocity of the induced air, m/s: right, up, ahead.</summary>
    public float3 Velocity { get; private set; }

    /// <summary>Adds the step that was just done.</summary>
    public void Add(int substeps)
    {
        IReadOnlyList<RecordedWing> wings = m_Wings.All;
        for (int k = 0; k < wings.Count; k++)
        {
            PresetSize size = wings[k].Wing.Preset.Size;
            WingReading reading = m_Wings.Read(k);
            m_Force += substeps * size.wingMass * size.wingLength * wings[k].Placement.DirectionToBody(reading.AirForce);
            int tip = reading.JointsPerChain - 1;
            float3 before = reading.JointPosition(0, tip, 0f);
            for (int place = 1; place <= k_Places; place++)
            {
                float3 after = reading.JointPosition(0, tip, (float)place / k_Places);
                m_Swept += 0.5 * size.wingLength * size.wingLength * math.length(math.cross(before, after));
                before = after;
            }
        }

        m_Substeps += substeps;
    }

    /// <summary>Ends a beat: the wings meet what it asks for from now on.</summary>
    public void EndBeat()
    {
        float3 force = m_Plan.ToWorld(m_Force / m_Substeps);
        // Both half strokes of both wings of each kind.
        double area = m_Swept / 2 / (m_Wings.All.Count / 2), size = math.length(force),
            density = m_Plan.Induced.Density ?? m_Wings.All[0].Wing.Preset.Size.fluidDensity;
        m_Force = default;
        m_Swept = 0;
        m_Substeps = 0;
        float3 wake = -math.normalizesafe(force), stream = m_Plan.AirPastBody;
        double along = math.dot(stream, wake), across = math.length(stream - (float)along * wake);
        double circle = m_Wings.All.Average(wing => Math.PI * wing.Wing.Preset.Size.wingLength * wing.Wing.Preset.Size.wingLength);
        double speed = size * area * density > 0 ? MomentumTheory.InFlight(size, density, area, circle, along, across) : 0;
        Velocity += Move((float)(m_Plan.Induced.Factor * speed) * wake - Velocity);
        m_Wings.Change(m_Plan with { Wind = [m_Plan.Wind[0] + Velocity.x, m_Plan.Wind[1] + Velocity.y, m_Plan.Wind[2] + Velocity.z] });
    }

    // A share of what lacks, the share by Aitken's rule from how the last one changed the lack (Küttler and Wall 2008).
    private float3 Move(float3 lack)
    {
        m_Share = Share(m_Share, m_Lack, lack);
        m_Lack = lack;
        return m_Share * lack;
    }

    internal static float Share(float last, float3 lackBefore, float3 lack)
    {
        float3 change = lack - lackBefore;
        return math.lengthsq(lackBefore) > 0f && math.lengthsq(change) > 0f
            ? math.clamp(-last * math.dot(lackBefore, change) / math.lengthsq(change), k_LeastShare, k_MostShare)
            : last;
    }
}
