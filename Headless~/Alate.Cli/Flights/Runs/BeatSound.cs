using Alate.Sound;

namespace Alate.Cli;

/// <summary>Sound of a beat that was flown, as Insect Hum plays it.</summary>
internal static class BeatSound
{
    public const int Rate = 48000;

    /// <summary>Root mean square, which leaves room for the peaks of a sound of many overtones.</summary>
    private const float k_Level = 0.2f;

    /// <summary>Samples of a beat that goes on.</summary>
    /// <param name="flight">The beat, all frames of it at once.</param>
    /// <param name="frequency">Beats a second as they are heard.</param>
    /// <param name="seconds">Length of the sound.</param>
    public static float[] Of(FlightRecord flight, double frequency, double seconds)
    {
        var beat = new BeatSpectrum();
        for (int k = 0; k < flight.Wings[0].Frames.Count; k++)
            beat.Add((float)(flight.Wings[0].Frames[k].Phase / (2.0 * Math.PI)), ForceAt(flight, k));
        var voice = new HumVoice();
        beat.Read(voice.Wanted.amplitudes);
        voice.Wanted.frequency = (float)frequency;
        voice.Wanted.level = k_Level;
        voice.Say();
        float[] samples = new float[(int)Math.Round(seconds * Rate)];
        Array.Fill(samples, 1f);
        voice.Multiply(samples, 1, Rate);
        return samples;
    }

    private static float3 ForceAt(FlightRecord flight, int frame)
    {
        float3 force = default;
        foreach (RecordedWing wing in flight.Wings)
        {
            PresetSize size = wing.Wing.Preset.Size;
            force += size.wingMass * size.wingLength * wing.Placement.DirectionToBody(wing.Frames[frame].AirForce);
        }

        return force;
    }
}
