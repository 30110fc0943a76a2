using System;
using System.Threading;

namespace Alate.Sound
{
    /// <summary>
    /// Plays a tone of overtones. One thread says what is wanted, another fills buffers: they exchange three tones and never wait for each
    /// other. Frequency, level and overtones glide, so that nothing clicks.
    /// </summary>
    internal sealed class HumVoice
    {
        /// <summary>Time in which a change has gone to 63 %, seconds.</summary>
        public const double GlideSeconds = 0.02;

        /// <summary>Overtones above this share of the sample rate are silent, so that none is heard as another one below.</summary>
        private const double k_HighestShare = 0.45;

        /// <summary>Below this level nothing is heard of 16 bits.</summary>
        private const double k_Silence = 1e-5;

        private readonly double[] m_Amplitudes = new double[BeatSpectrum.Overtones];
        private HumTone m_Written = new HumTone(), m_Between = new HumTone(), m_Played = new HumTone();
        private int m_IsFresh;
        private double m_Turn, m_Frequency, m_Level;

        /// <summary>The tone to fill in, before <see cref="Say"/>; for one thread.</summary>
        public HumTone Wanted => m_Written;

        /// <summary>Hands <see cref="Wanted"/> over to the thread that plays.</summary>
        public void Say()
        {
            m_Written = Interlocked.Exchange(ref m_Between, m_Written);
            Volatile.Write(ref m_IsFresh, 1);
        }

        /// <summary>Multiplies a buffer by the tone, as long as the buffer is.</summary>
        /// <param name="data">Samples, all channels of one moment side by side.</param>
        /// <param name="channels">Channels, 1 or more.</param>
        /// <param name="sampleRate">Moments a second, above 0.</param>
        public void Multiply(float[] data, int channels, int sampleRate)
        {
            if (Interlocked.Exchange(ref m_IsFresh, 0) == 1)
                m_Played = Interlocked.Exchange(ref m_Between, m_Played);
            if (m_Level == 0.0 && m_Played.level > 0f)
                Start();
            double glide = 1.0 - Math.Exp(-1.0 / (GlideSeconds * sampleRate));
            int moments = data.Length / channels;
            for (int moment = 0; moment < moments; moment++)
            {
                m_Frequency += glide * (m_Played.frequency - m_Frequency);
                m_Level += glide * (m_Played.level - m_Level);
                if (m_Played.level == 0f && m_Level < k_Silence)
                    m_Level = 0.0;
                float sample = m_Level == 0.0 ? 0f : (float)Sample(glide, k_HighestShare * sampleRate);
                m_Turn += m_Frequency / sampleRate;
                m_Turn -= Math.Floor(m_Turn);
                for (int channel = 0; channel < channels; channel++)
                    data[moment * channels + channel] *= sample;
            }
        }

        // From silence a tone starts as it is wanted: nothing that was heard can jump.
        private void Start()
        {
            m_Frequency = m_Played.frequency;
            m_Turn = 0.0;
            for (int k = 0; k < m_Amplitudes.Length; k++)
                m_Amplitudes[k] = m_Played.amplitudes[k];
        }

        private double Sample(double glide, double highest)
        {
            // sin (n + 1) a = 2 cos a sin n a − sin (n − 1) a
            double angle = 2.0 * Math.PI * m_Turn, sine = Math.Sin(angle), before = 0.0, twice = 2.0 * Math.Cos(angle), sum = 0.0;
            for (int k = 0; k < m_Amplitudes.Length; k++)
            {
                double wanted = (k + 1) * m_Frequency < highest ? m_Played.amplitudes[k] : 0.0;
                m_Amplitudes[k] += glide * (wanted - m_Amplitudes[k]);
                sum += m_Amplitudes[k] * sine;
                double after = twice * sine - before;
                before = sine;
                sine = after;
            }

            return Math.Max(-1.0, Math.Min(m_Level * sum, 1.0));
        }
    }
}
