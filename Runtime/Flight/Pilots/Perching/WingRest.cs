using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Folding of the wings while an insect sits: closed at first, then open and closed slowly, spread again before it flies.
    /// </summary>
    public struct WingRest
    {
        private float m_Time, m_Turns;

        /// <summary>Share of the folded posture, 0 (spread) to 1 (folded).</summary>
        public float Fold { get; private set; }

        /// <summary>Advances the folding by a step.</summary>
        /// <param name="dt">Seconds.</param>
        /// <param name="sits">Whether the insect sits; otherwise the wings are spread at once: they beat.</param>
        /// <param name="settings">How it rests.</param>
        public void Step(float dt, bool sits, in PerchSettings settings)
        {
            if (!sits)
            {
                this = default;
                return;
            }

            m_Time += dt;
            float since = m_Time - settings.foldTime;
            float wanted = 1f;
            if (since > 0f && settings.bask > 0f)
            {
                // Added up, so that a rate that changes shifts nothing.
                m_Turns = math.frac(m_Turns + math.min(dt, since) * settings.fanRate / 60f);
                wanted = 1f - settings.bask * (settings.fanRate > 0f ? 0.5f - 0.5f * Elementary.Cos(2f * math.PI * m_Turns) : 1f);
            }

            float most = dt / settings.foldTime;
            Fold += math.clamp(wanted - Fold, -most, most);
        }
    }
}
