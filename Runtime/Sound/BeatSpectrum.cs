using System;
using Unity.Mathematics;

namespace Alate.Sound
{
    /// <summary>
    /// Overtones of the sound of a beat, from the force that the wings have on the air at each phase. A body much smaller than its waves
    /// radiates by the rate of that force (Gutin 1936), so that the overtone n is n times as strong in the sound as in the force.
    /// </summary>
    internal sealed class BeatSpectrum
    {
        /// <summary>Overtones, the beat itself the first.</summary>
        public const int Overtones = 16;

        private const int k_Phases = 64;

        /// <summary>Share of a new force in what is known of its phase: frames meet a phase again and again.</summary>
        private const float k_Renewal = 0.5f;

        /// <summary>A force that changes by less than this share of its square is steady, but for rounding.</summary>
        private const float k_Steady = 1e-8f;

        private static readonly float2[] s_Turns = Turns();

        private readonly float3[] m_Forces = new float3[k_Phases];
        private readonly float3[] m_Whole = new float3[k_Phases];
        private readonly bool[] m_Known = new bool[k_Phases];

        /// <summary>Forgets all forces.</summary>
        public void Clear() => Array.Clear(m_Known, 0, k_Phases);

        /// <summary>Adds the force at a phase.</summary>
        /// <param name="phase">Phase of the beat, 0 to 1.</param>
        /// <param name="force">Force of all wings, any unit; not finite is left out.</param>
        public void Add(float phase, float3 force)
        {
            if (!(phase >= 0f && phase <= 1f) || !math.all(math.isfinite(force)))
                return;
            int at = math.min((int)(phase * k_Phases), k_Phases - 1);
            m_Forces[at] = m_Known[at] ? math.lerp(m_Forces[at], force, k_Renewal) : force;
            m_Known[at] = true;
        }

        /// <summary>Computes the overtones; phases that no frame has met lie on the line between those beside them.</summary>
        /// <param name="amplitudes">[overtone − 1] Takes their amplitudes, such that the root mean square of the sound is 1; 0 for a force
        /// that stays the same.</param>
        public void Read(float[] amplitudes)
        {
            Fill();
            float squares = 0f, least = 0f;
            for (int k = 0; k < k_Phases; k++)
                least += k_Steady * k_Phases * math.lengthsq(m_Whole[k]);
            for (int overtone = 1; overtone <= Overtones; overtone++)
            {
                float3 cosine = default, sine = default;
                for (int k = 0; k < k_Phases; k++)
                {
                    float2 turn = s_Turns[k * overtone % k_Phases];
                    cosine += m_Whole[k] * turn.x;
                    sine += m_Whole[k] * turn.y;
                }

                float squared = overtone * overtone * (math.lengthsq(cosine) + math.lengthsq(sine));
                amplitudes[overtone - 1] = math.sqrt(squared);
                squares += squared;
            }

            float scale = squares > least ? math.rsqrt(0.5f * squares) : 0f;
            for (int k = 0; k < Overtones; k++)
                amplitudes[k] *= scale;
        }

        private void Fill()
        {
            int first = Array.IndexOf(m_Known, true);
            for (int k = 0; first < 0 && k < k_Phases; k++)
                m_Whole[k] = float3.zero;
            for (int known = first; first >= 0 && known < first + k_Phases;)
            {
                int next = known + 1;
                while (!m_Known[next % k_Phases])
                    next++;
                float3 from = m_Forces[known % k_Phases], to = m_Forces[next % k_Phases];
                for (int k = known; k < next; k++)
                    m_Whole[k % k_Phases] = math.lerp(from, to, (k - known) / (float)(next - known));
                known = next;
            }
        }

        private static float2[] Turns()
        {
            var turns = new float2[k_Phases];
            for (int k = 0; k < k_Phases; k++)
            {
                float angle = 2f * math.PI * k / k_Phases;
                turns[k] = new float2(math.cos(angle), math.sin(angle));
            }

            return turns;
        }
    }
}
