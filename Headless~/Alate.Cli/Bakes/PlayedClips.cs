using Alate.Crowds;
using Alate.Flight;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Clips in which an insect goes from one place to another, as it does in a game: it comes in and sits down on a spot, the origin, or
/// flies off it. Joints alone are kept, a frame at even times.
/// </summary>
internal sealed class PlayedClips : IDisposable
{
    private const string k_Land = "land", k_TakeOff = "take-off";

    /// <summary>
    /// Seconds that a clip shows of the way to the spot, of that off it, and for which the insect sits with its wings folded.
    /// </summary>
    private const float k_Way = 1.5f, k_WayOff = 2.5f, k_Stay = 0.5f;

    /// <summary>Longest time of a landing, and frames of a clip.</summary>
    private const float k_Patience = 30f;
    private const int k_MostFrames = 20000;

    /// <summary>Place from which the insect comes, wing lengths above and behind the spot.</summary>
    private const float k_Above = 8f, k_Behind = 10f;

    private readonly InsectWings m_Insect;
    private readonly InsectFlight m_Flight;
    private readonly PerchPilot m_Pilot;
    private readonly InsectBake m_Bake;
    private readonly AbdomenSwing[] m_Abdomens;
    private readonly Quaternion[] m_Rest;
    private readonly int m_FramesPerBeat;
    private readonly List<BakedFrame> m_Frames = [];
    private readonly List<BakedJoint> m_Path = [];
    private DrawnInsect m_Drawn;
    private float m_Step;

    /// <param name="insect">One that flies, and does not play yet.</param>
    /// <param name="bake">Its bake.</param>
    /// <param name="framesPerBeat">Frames in the time of a beat.</param>
    private PlayedClips(InsectWings insect, InsectBake bake, int framesPerBeat)
    {
        m_Insect = insect;
        m_Bake = bake;
        m_FramesPerBeat = framesPerBeat;
        m_Flight = insect.GetComponent<InsectFlight>();
        m_Pilot = insect.gameObject.AddComponent<PerchPilot>();
        insect.gameObject.AddComponent<AheadPilot>();
        m_Pilot.Seed = 1;
        m_Pilot.Settings = new PerchSettings
        {
            stayTime = PerchBounds.StayTime.Max,
            flightTime = PerchBounds.FlightTime.Max,
            foldTime = PerchBounds.FoldTime.Default,
        };
        m_Abdomens = insect.GetComponentsInChildren<AbdomenSwing>();
        m_Rest = Array.ConvertAll(m_Abdomens, abdomen => abdomen.transform.localRotation);
        insect.Quality.culling = WingCulling.AlwaysSimulate;
        insect.Quality.levelOfDetail = false;

        // A frame is a step: what is drawn is not between two.
        insect.UpdateMode = WingUpdateMode.Update;
    }

    /// <summary>Names of the clips.</summary>
    public static IReadOnlyList<string> Names { get; } = [k_Land, k_TakeOff];

    /// <summary>Plays clips.</summary>
    /// <param name="insect">Makes an insect that flies.</param>
    /// <param name="bake">Its bake, whose joints are meant.</param>
    /// <param name="names">Those of <see cref="Names"/>.</param>
    /// <param name="framesPerBeat">Frames in the time of a beat.</param>
    /// <param name="beatsPerSecond">Beats a second in the file; null for the insect's own.</param>
    /// <exception cref="UserException">The insect does not fly, or does not land.</exception>
    public static List<BakedClip> Play(
        Func<InsectWings> insect, InsectBake bake, IReadOnlyList<string> names, int framesPerBeat, double? beatsPerSecond)
    {
        PlayerLoop.EnterPlayMode();
        try
        {
            using var clips = new PlayedClips(insect(), bake, framesPerBeat);
            return [.. clips.Play(names, beatsPerSecond)];
        }
        finally
        {
            PlayerLoop.ExitPlayMode();
        }
    }

    /// <inheritdoc/>
    public void Dispose() => m_Drawn?.Dispose();

    private IEnumerable<BakedClip> Play(IReadOnlyList<string> names, double? beatsPerSecond)
    {
        float length = m_Bake.WingLength;
        m_Insect.transform.position = new Vector3(0f, k_Above * length, -k_Behind * length);
        PlayerLoop.Tick(1f / 60f);
        if (m_Flight.Problem != FlightProblem.None)
        {
            throw new UserException(
                $"Clip '{names[0]}' is flown by trims, and '{m_Insect.name}' has none for its numbers: 'trim FILE --bake' makes them.");
        }

        m_Drawn = new DrawnInsect(m_Insect);
        float frequency = m_Insect.Frequency;
        m_Step = 1f / (m_FramesPerBeat * frequency);
        double rate = m_FramesPerBeat * (beatsPerSecond ?? frequency);
        Fly(() => m_Flight.State == FlightState.Flying, k_Way, k_Land);
        Forget();
        m_Pilot.LandOn(new PerchSpot { normal = new float3(0f, 1f, 0f), heading = 0f });
        int before = (int)(k_Way / m_Step);
        Fly(() => m_Flight.State == FlightState.Perched, k_Patience, k_Land, before);
        Fly(() => m_Flight.State == FlightState.Perched && m_Pilot.Fold >= 1f, k_Patience, k_Land);
        PlayFor(k_Stay);
        if (names.Contains(k_Land))
            yield return Clip(k_Land, rate);
        Forget();
        Next();
        m_Pilot.TakeOff();
        Fly(() => m_Flight.State == FlightState.Flying, k_Patience, k_TakeOff);
        PlayFor(k_WayOff);
        if (names.Contains(k_TakeOff))
            yield return Clip(k_TakeOff, rate);
    }

    // Until something is so; of what was before that, so many frames are kept.
    private void Fly(Func<bool> isThere, float longest, string clip, int keeps = int.MaxValue)
    {
        for (float time = 0f; !isThere(); time += m_Step)
        {
            if (time > longest)
            {
                throw new UserException(FormattableString.Invariant(
                    $"Clip '{clip}' cannot be played: {m_Insect.name} is {m_Flight.State} after {time:0.0} s. ")
                    + "Only insects that land have it.");
            }

            Next();
            if (m_Frames.Count > keeps)
            {
                m_Frames.RemoveAt(0);
                m_Path.RemoveAt(0);
            }
        }
    }

    private void PlayFor(float seconds)
    {
        for (float time = 0f; time < seconds; time += m_Step)
            Next();
    }

    private void Forget()
    {
        m_Frames.Clear();
        m_Path.Clear();
    }

    private void Next()
    {
        if (m_Frames.Count == k_MostFrames)
        {
            throw new UserException(FormattableString.Invariant(
                $"Clips that play once would have more than {k_MostFrames} frames: take fewer --frames than {m_FramesPerBeat}."));
        }

        PlayerLoop.Tick(m_Step);
        var frame = new BakedFrame(0, m_Bake.JointCount);
        for (int w = 0; w < m_Bake.Wings.Count; w++)
            m_Drawn.Wings[w].Write(m_Insect.Read(w), m_Bake.Wings[w], frame);
        for (int k = 0; k < m_Abdomens.Length; k++)
        {
            frame.Joints[m_Bake.Abdomens[k].Joint] = new BakedJoint(
                m_Bake.Abdomens[k].Hinge, m_Abdomens[k].transform.localRotation * Quaternion.Inverse(m_Rest[k]));
        }

        m_Frames.Add(frame);
        m_Path.Add(new BakedJoint(m_Insect.transform.position, m_Insect.transform.rotation));
    }

    // Flies straight ahead when nothing is to land on.
    private sealed class AheadPilot : FlightPilot
    {
        /// <summary>Speed over the top speed.</summary>
        private const float k_Speed = 0.5f;

        public override FlightCommand Command(in FlightSituation situation) =>
            FlightCommand.Fly(new float3(0f, 0f, k_Speed * situation.limits.TopSpeed), 0f);
    }

    private BakedClip Clip(string name, double rate) => new()
    {
        Motion = new BakeMotion(name),
        Frequency = (float)(rate / m_Frames.Count),
        Frames = [.. m_Frames],
        Path = [.. m_Path],
    };
}
