using System;
using System.Numerics;

namespace Alate.Benchmarks;

/// <summary>Eq. 6 and 7 for one wing: phase, latched frequency and amplitudes.</summary>
internal sealed class PlainBeat
{
    private readonly WingParameters m_Parameters;
    private readonly WingSurroundings m_Air;
    private float m_Frequency;
    private float m_PreviousFrequency;

    public PlainBeat(in WingParameters parameters, in WingSurroundings air)
    {
        m_Parameters = parameters;
        m_Air = air;
        m_Frequency = m_PreviousFrequency = Frequency();
        Array.Fill(amplitudes, Amplitude());
        rate = 2f * MathF.PI * m_Frequency;
    }

    public float phase;
    public float rate;
    public int cycles;

    /// <summary>Flap, sweep and feather of this cycle and the four before.</summary>
    public readonly Vector3[] amplitudes = new Vector3[5];

    public void Advance(float h)
    {
        float x = Math.Clamp(phase / MathF.PI, 0f, 1f);
        rate = 2f * MathF.PI * (m_PreviousFrequency + (m_Frequency - m_PreviousFrequency) * (x * x * (3f - 2f * x)));
        phase += rate * h;
        if (phase < 2f * MathF.PI)
            return;
        phase -= 2f * MathF.PI;
        cycles++;
        m_PreviousFrequency = m_Frequency;
        m_Frequency = Frequency();
        Array.Copy(amplitudes, 0, amplitudes, 1, 4);
        amplitudes[0] = Amplitude();
    }

    /// <summary>Goes on from where a wing of a pack is.</summary>
    public void Follow(in BeatState beat, int lane)
    {
        phase = beat.phase[lane];
        rate = beat.rate[lane];
        cycles = (int)beat.cycles[lane];
        amplitudes[0] = PlainRig.Plain(beat.amplitude[lane]);
        amplitudes[1] = PlainRig.Plain(beat.amplitude1[lane]);
        amplitudes[2] = PlainRig.Plain(beat.amplitude2[lane]);
        amplitudes[3] = PlainRig.Plain(beat.amplitude3[lane]);
        amplitudes[4] = PlainRig.Plain(beat.amplitude4[lane]);
    }

    private float Slope() => 1f / (1f + MathF.Exp(-16f * (m_Air.speed / m_Parameters.maxSpeed - 0.5f)));

    private float Frequency() => m_Parameters.maxFrequency * MathF.Max(Slope(), m_Parameters.frequencyFloor);

    private Vector3 Amplitude() => PlainRig.Plain(m_Parameters.amplitude) * MathF.Max(Slope(), m_Parameters.amplitudeFloor);
}
