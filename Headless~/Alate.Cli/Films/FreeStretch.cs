namespace Alate.Cli;

/// <summary>
/// Some beats of a free flight along the erratic track of <c>fly --free --pilot wander</c>, with a camera that goes along.
/// </summary>
internal sealed class FreeStretch
{
    /// <summary>Seconds after which the insect is under way.</summary>
    private const double k_Start = 2.0;

    private const int k_Seed = 1;

    /// <summary>Dots of the trail in a beat, and beats before the film that it has already.</summary>
    private const int k_Dots = 8, k_BeatsBefore = 3;

    private readonly FilmPlan m_Plan;
    private readonly FreeRecord m_Record;
    private readonly float3[] m_Places;
    private readonly int m_First;
    private readonly quaternion m_Ahead;

    /// <summary>The last beats of a flight but one.</summary>
    internal FreeStretch(FilmPlan plan, FreeRecord record)
    {
        m_Plan = plan;
        m_Record = record;
        m_Places = record.Moments.Select(at => record.Thorax(at)).ToArray();
        // A beat is left behind the last frame, for the mean of the camera.
        m_First = record.Moments.Count - (plan.Beats + 1) * plan.Frames;
        float3 ahead = math.rotate(record.Moments[m_First + plan.Beats * plan.Frames / 2].Rotation, new float3(0f, 0f, 1f));
        m_Ahead = quaternion.RotateY(-math.atan2(ahead.x, ahead.z));
    }

    /// <summary>The beat on the spot whose shapes stand for all.</summary>
    public FlightRecord Beat => m_Record.Beat;

    /// <summary>Flies what a film shows.</summary>
    /// <exception cref="UserException">The insect does not fly.</exception>
    public static FreeStretch Fly(FilmPlan plan)
    {
        InsectDefinition insect = plan.Flight.Definition;
        double frequency = TetheredFlight.Fly(FlightPlan.Cruise(insect, InsectVariant.Flight)).Wings[0].Frequency;
        double step = math.clamp(1.0 / (frequency * plan.Frames), 0.001, 0.05);
        var flight =
            new FreePlan
            {
                Insect = insect,
                Pilot = FreePilot.Wander,
                Seed = k_Seed,
                Step = step,
                Seconds = k_Start + (plan.Beats + 1) * plan.Frames * step,
            };
        return new FreeStretch(plan, FreeRun.Fly(flight, _ => { }));
    }

    /// <summary>
    /// A frame, seen as if the insect looked ahead in the middle of the film. The camera follows the mean of a beat, so that the bob of the
    /// body is left.
    /// </summary>
    public FilmMoment At(int frame)
    {
        int now = m_First + frame, between = Math.Max(m_Plan.Frames / k_Dots, 1);
        FreeMoment at = m_Record.Moments[now];
        float3 camera = Mean(now);
        var trail = new List<float3>();
        for (int k = Math.Max(m_First - k_BeatsBefore * m_Plan.Frames, 0); k < now; k++)
        {
            if (k % between == 0)
                trail.Add(math.rotate(m_Ahead, m_Places[k] - camera));
        }

        return new FilmMoment(
            at.Phase / (2.0 * Math.PI), math.mul(m_Ahead, at.Rotation), math.rotate(m_Ahead, m_Places[now] - camera), trail);
    }

    // More than half a beat lies before the film, and a whole one behind it.
    private float3 Mean(int now)
    {
        float3 sum = 0f;
        for (int k = now - m_Plan.Frames / 2; k < now - m_Plan.Frames / 2 + m_Plan.Frames; k++)
            sum += m_Places[k];
        return sum / m_Plan.Frames;
    }
}
