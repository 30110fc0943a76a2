using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Budget of the time that wings may take of a frame: while it is exceeded, far insects count as smaller on the screen than they are,
    /// the more so the farther they are from the nearest, which counts with its own size.
    /// </summary>
    internal sealed class DetailBudget
    {
        /// <summary>Share of a frame in the mean: what counts is the time of the last half second or so.</summary>
        private const float k_Memory = 0.03f;

        /// <summary>Change of the logarithm of the sizes in a frame that takes twice the budget.</summary>
        private const float k_Gain = 0.015f;

        /// <summary>Share of the budget below which insects grow again.</summary>
        private const float k_Low = 0.9f;

        /// <summary>Logarithm of the smallest size, over its own, that an insect counts with.</summary>
        private const float k_Smallest = -7f;

        private float m_Spent, m_Farness, m_Nearest, m_Largest;

        /// <summary>Time of a frame, mean over the last ones, milliseconds.</summary>
        public float Mean { get; private set; }

        /// <summary>True while insects count as smaller than they are.</summary>
        public bool IsTight => m_Farness < 0f;

        /// <summary>Adds time to the frame.</summary>
        public void Spend(float milliseconds) => m_Spent += milliseconds;

        /// <summary>Ends a frame.</summary>
        /// <param name="budget">Milliseconds of a frame; 0 for none.</param>
        public void EndFrame(float budget)
        {
            m_Nearest = m_Largest;
            m_Largest = 0f;
            Mean += k_Memory * (m_Spent - Mean);
            m_Spent = 0f;
            float load = budget > 0f ? Mean / budget : 0f;
            if (load > 1f)
                m_Farness -= k_Gain * math.min(load - 1f, 1f);
            else if (load < k_Low)
                m_Farness += k_Gain * (k_Low - load);
            m_Farness = budget > 0f ? math.clamp(m_Farness, k_Smallest, 0f) : 0f;
        }

        /// <summary>Size with which an insect counts.</summary>
        /// <param name="height">Share of the screen's height that it fills.</param>
        public float Counted(float height)
        {
            m_Largest = math.max(m_Largest, height);
            return IsTight && m_Nearest > 0f ? height * Elementary.Exp(m_Farness * (1f - math.saturate(height / m_Nearest))) : height;
        }
    }
}
