using System.Diagnostics;

namespace Alate.Cli;

/// <summary>
/// Wake of wings on the spot while they fly. The flight hands over where the edges of its wings are at each 24th of a beat, a worker steps
/// a free wake, and the flight writes the newest sheets that are done, as far as the air has carried them since. Where the worker falls
/// behind, it leaves out whole beats, and sheets of an earlier beat are written: those of the same phase, for the beat repeats.
/// </summary>
internal sealed class LiveWake : IDisposable
{
    /// <summary>Steps of a beat, and strips along the span.</summary>
    public const int StepsPerBeat = 24, Panels = 10;

    /// <summary>Change of the frequency from which on the wake is that of another beat.</summary>
    private const double k_OtherBeat = 0.01;

    /// <summary>Most steps over which sheets are carried on.</summary>
    private const int k_MostSteps = 3;

    /// <summary>Part of a step by which a moment may be late, for rounding.</summary>
    private const double k_Late = 1e-4;

    /// <summary>Largest of the whole numbers that stand for places and circulations.</summary>
    private const float k_Quanta = short.MaxValue;

    private readonly TetheredWings m_Wings;
    private readonly WakeGrid[] m_Grids;
    private readonly bool m_IsSymmetric;
    private readonly float3[] m_Points;
    private float3 m_Air;
    private double m_Turn = double.NaN;

    // Guards the moments, the sheets that are done, the pace and the run; not held over a step.
    private readonly object m_Gate = new();
    private readonly WakeMoments m_Moments;
    private readonly FlownSheets[] m_Done;
    private WakePace m_Pace;
    private int m_Run;
    private bool m_IsQueued;

    // Guards what the worker has; held over a step.
    private readonly object m_Stepping = new();
    private readonly float3[] m_Places;
    private readonly bool[] m_IsLeft;
    private readonly WakeStepper m_Stepper;
    private FlownSheets m_Before;
    private int m_SteppedRun;
    private bool m_IsDisposed;

    /// <summary>Lays strips on all wings; nothing has been shed.</summary>
    /// <param name="wings">The wings.</param>
    /// <param name="plan">Their flight.</param>
    /// <exception cref="UserException">A wing has no chord somewhere.</exception>
    public LiveWake(TetheredWings wings, FlightPlan plan)
    {
        m_Wings = wings;
        m_Air = plan.AirInBodyAxes;
        m_IsSymmetric = m_Air.x == 0f;
        m_Grids = [.. wings.All.Select(wing => new WakeGrid(wing, Panels))];
        RecordedWing[] computed = [.. wings.All.Where(wing => !m_IsSymmetric || !wing.Placement.IsLeft)];
        m_IsLeft = [.. computed.Select(wing => wing.Placement.IsLeft)];
        int rows = WakeStepper.Rows(StepsPerBeat), width = Panels + 1;
        m_Stepper = new WakeStepper(computed, StepsPerBeat, Panels, m_IsSymmetric);
        m_Moments = new WakeMoments(StepsPerBeat, computed.Length * m_Grids[0].Count);
        m_Places = new float3[computed.Length * m_Grids[0].Count];
        m_Done = [.. Enumerable.Range(0, StepsPerBeat).Select(_ => new FlownSheets(computed.Length, rows, width))];
        m_Points = new float3[(rows + 1) * width];
    }

    /// <summary>Number of steps done, and the time that they took.</summary>
    public (long Count, TimeSpan Time) Steps { get; private set; }

    /// <summary>True where no moment waits for its step.</summary>
    public bool IsIdle
    {
        get
        {
            lock (m_Gate)
                return !m_IsQueued;
        }
    }

    /// <summary>Drops the wake, as the flight is another one from here on.</summary>
    /// <param name="plan">The flight; the air still comes from the side or does not.</param>
    public void Restart(FlightPlan plan)
    {
        m_Air = plan.AirInBodyAxes;
        Restart(0f);
    }

    /// <summary>Hands over the moments of the wings' last step.</summary>
    /// <param name="turn">Time at its end, beats.</param>
    /// <param name="seconds">Its length.</param>
    /// <param name="frequency">Of the beat, hertz.</param>
    public void Follow(double turn, double seconds, double frequency)
    {
        bool isOther = !(Math.Abs(frequency * m_Pace.Period - 1.0) <= k_OtherBeat) || turn < m_Turn;
        double start = isOther || double.IsNaN(m_Turn) ? turn - seconds * frequency : m_Turn;
        if (isOther)
            Restart((float)(1.0 / frequency));
        m_Turn = turn;
        for (long index = 1 + Moment(start); index <= Moment(turn); index++)
        {
            double share = ((double)index / StepsPerBeat - start) / (turn - start);
            m_Wings.World.Skin((float)Math.Clamp(share, 0.0, 1.0));
            HandOver(index);
        }
    }

    /// <summary>Does the step of the oldest moment; the worker's.</summary>
    /// <returns>True where another one may wait.</returns>
    public bool Step()
    {
        lock (m_Stepping)
        {
            long index = 0;
            int run;
            WakePace pace;
            lock (m_Gate)
            {
                m_IsQueued = !m_IsDisposed && m_Moments.TryTake(m_Places, out index);
                if (!m_IsQueued)
                    return false;
                (run, pace) = (m_Run, m_Pace);
            }

            if (run != m_SteppedRun)
                m_Stepper.Restart();
            m_Before = run == m_SteppedRun ? m_Before : null;
            m_SteppedRun = run;
            long start = Stopwatch.GetTimestamp();
            if (m_Stepper.Step(m_Places, pace))
            {
                Steps = (Steps.Count + 1, Steps.Time + Stopwatch.GetElapsedTime(start));
                Take(index, run, pace);
            }

            return true;
        }
    }

    /// <summary>Adds the sheets of all wings to a state: see the file format.js of the page.</summary>
    /// <param name="buffer">The state.</param>
    /// <param name="turn">Time that is drawn, beats.</param>
    /// <param name="positions">[wing][vertex] Meshes that are drawn, wing frames.</param>
    public void Write(StateBuffer buffer, double turn, float3[][] positions)
    {
        lock (m_Gate)
        {
            FlownSheets sheets = At(turn, out float steps);
            buffer.Add(sheets == null ? 0u : (uint)m_Grids.Length);
            if (sheets == null)
                return;
            float strongest = 1e-12f;
            foreach (FlownSheets done in m_Done)
                strongest = math.max(strongest, done.Strongest);
            for (int wing = 0; wing < m_Grids.Length; wing++)
                Write(buffer, sheets, steps, wing, positions[wing], strongest);
        }
    }

    public void Dispose()
    {
        lock (m_Stepping)
        {
            m_IsDisposed = true;
            m_Stepper.Dispose();
        }
    }

    private static long Moment(double turn) => (long)Math.Floor(turn * StepsPerBeat + k_Late);

    private void Restart(float period)
    {
        lock (m_Gate)
        {
            m_Run++;
            m_Pace = new WakePace(period, m_Air);
            m_Moments.Clear();
            foreach (FlownSheets sheets in m_Done)
                sheets.Clear();
        }
    }

    private void HandOver(long index)
    {
        float3[] next;
        lock (m_Gate)
            next = m_Moments.Next;
        int stride = m_Grids[0].Count, each = m_IsSymmetric ? 2 : 1;
        for (int k = 0; k * stride < next.Length; k++)
        {
            int wing = k * each;
            m_Grids[wing].Take(m_Wings.Vertices(wing), m_Wings.FrameOf(wing), next.AsSpan(k * stride, stride));
        }

        bool isDue;
        lock (m_Gate)
        {
            m_Moments.Add(index);
            isDue = !m_IsQueued;
            m_IsQueued = true;
        }

        if (isDue)
            WakeWorker.Shared.Add(this);
    }

    private void Take(long index, int run, in WakePace pace)
    {
        lock (m_Gate)
        {
            if (run != m_Run)
                return;
            FlownSheets sheets = m_Done[index % StepsPerBeat];
            sheets.Take(
                index, m_Stepper.Wake, m_Stepper.Length, pace.Period, pace.Air * (pace.Period / StepsPerBeat), m_IsLeft, m_Before);
            m_Before = sheets;
        }
    }

    // The newest sheets before a time, or those of its phase in an earlier beat.
    private FlownSheets At(double turn, out float steps)
    {
        long now = Moment(turn);
        for (int late = 0; late < k_MostSteps && late <= now; late++)
        {
            FlownSheets sheets = m_Done[(now - late) % StepsPerBeat];
            steps = (float)(turn * StepsPerBeat - (now - late));
            if (sheets.Index == now - late)
                return sheets;
        }

        FlownSheets earlier = m_Done[now % StepsPerBeat];
        steps = (float)(turn * StepsPerBeat - now);
        return earlier.Index >= 0 ? earlier : null;
    }

    // A row at the trailing edge as it is drawn, with the circulation that leaves it, and behind it the rows that were shed.
    private void Write(StateBuffer buffer, FlownSheets sheets, float steps, int wing, float3[] positions, float strongest)
    {
        int width = Panels + 1, count = (sheets.Rows + 1) * width, computed = m_IsSymmetric ? wing / 2 : wing;
        bool isMirrored = m_IsSymmetric && wing % 2 == 1;
        float reach = 1e-12f;
        for (int k = 0; k < count; k++)
        {
            float3 point = k < width ? m_Grids[wing].TrailingEdge(k, positions) : sheets.Point(computed, k - width, steps);
            point.x = isMirrored && k >= width ? -point.x : point.x;
            m_Points[k] = FileAxes.ToGltf(point);
            reach = math.max(reach, math.length(m_Points[k]));
        }

        buffer.Add((uint)(count / width));
        buffer.Add((uint)width);
        buffer.Add(reach);
        buffer.Add(strongest);
        Span<short> written = buffer.Add<short>(4 * count);
        for (int k = 0; k < count; k++)
        {
            float3 place = math.round(k_Quanta * (m_Points[k] / reach));
            float circulation = math.clamp(sheets.Circulation(computed, Math.Max(k - width, k % width)) / strongest, -1f, 1f);
            (written[4 * k], written[4 * k + 1], written[4 * k + 2], written[4 * k + 3]) =
                ((short)place.x, (short)place.y, (short)place.z, (short)math.round(k_Quanta * circulation));
        }
    }
}
