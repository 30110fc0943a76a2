using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Exchange of circulation between neighbouring strips that are stalled. Beyond the stall lift falls with the angle, so that a strip of
    /// more circulation than its neighbours, whose own trailing vortices lower its angle, asks for still more: circulations that alternate
    /// from strip to strip would solve the equations of a lifting line, or none would. An artificial viscosity, as large as that answer,
    /// smooths them; there is none where the flow is attached, and it goes with the width of the strips.
    /// </summary>
    internal sealed class StalledStrips
    {
        private readonly int[] m_First;

        // [strip] Share of the difference to each neighbour that it takes.
        private readonly float[] m_Exchange;

        /// <param name="first">[wing] Number of its first strip; last the number of all.</param>
        public StalledStrips(int[] first)
        {
            m_First = first;
            m_Exchange = new float[first[first.Length - 1]];
        }

        /// <summary>Forgets all strips, before a step.</summary>
        public void Clear() => System.Array.Clear(m_Exchange, 0, m_Exchange.Length);

        /// <summary>Notes how a strip answers to its own circulation; the largest answer of a step counts.</summary>
        /// <param name="strip">Number of the strip.</param>
        /// <param name="answer">Circulation that the strip asks for, per circulation that it has; above 0 where it is stalled.</param>
        /// <returns>True where it exchanges more than before.</returns>
        public bool Meet(int strip, float answer)
        {
            if (!(answer > m_Exchange[strip]))
                return false;
            m_Exchange[strip] = answer;
            return true;
        }

        /// <summary>Circulation that a strip takes from its neighbours on the wing.</summary>
        public float Taken(int wing, int strip, float[] circulation)
        {
            float sum = 0f;
            if (strip > m_First[wing])
                sum += circulation[strip - 1] - circulation[strip];
            if (strip < m_First[wing + 1] - 1)
                sum += circulation[strip + 1] - circulation[strip];
            return m_Exchange[strip] * sum;
        }

        /// <summary>Derivative of <see cref="Taken"/> over the circulation of another strip, or its own.</summary>
        public float Slope(int wing, int strip, int source)
        {
            if (source == strip)
                return -m_Exchange[strip] * ((strip > m_First[wing] ? 1f : 0f) + (strip < m_First[wing + 1] - 1 ? 1f : 0f));
            bool isBeside = math.abs(source - strip) == 1 && source >= m_First[wing] && source < m_First[wing + 1];
            return isBeside ? m_Exchange[strip] : 0f;
        }
    }
}
