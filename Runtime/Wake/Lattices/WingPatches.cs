using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Patches of the strips of a wing at a moment, each of which meets the air by itself, as those of the model do: a wing that turns,
    /// bends and twists has another angle at its leading edge than at its trailing edge.
    /// </summary>
    internal sealed class WingPatches
    {
        /// <summary>Patches of a strip along the chord and along the span.</summary>
        private const int k_Across = 4, k_Along = 2;

        private readonly IWingMotion m_Motion;
        private readonly int m_Rows;
        private readonly float2[] m_Places;
        private readonly float3[] m_Corners, m_Velocities;

        /// <summary>Lays patches on a wing; they are nowhere yet.</summary>
        /// <param name="motion">Of the wing.</param>
        /// <param name="strips">Number of strips, which cover the wing from root to tip.</param>
        public WingPatches(IWingMotion motion, int strips)
        {
            m_Motion = motion;
            m_Rows = strips * k_Along;
            m_Places = new float2[(k_Across + 1) * (m_Rows + 1)];
            m_Corners = new float3[m_Places.Length];
            m_Velocities = new float3[m_Places.Length];
            All = new WingPatch[k_Across * m_Rows];
            for (int row = 0; row <= m_Rows; row++)
            {
                for (int i = 0; i <= k_Across; i++)
                    m_Places[Corner(row, i)] = new float2((float)i / k_Across, (float)row / m_Rows);
            }
        }

        /// <summary>Number of patches of a strip.</summary>
        public static int PerStrip => k_Across * k_Along;

        /// <summary>[strip · patches of a strip + patch]</summary>
        public WingPatch[] All { get; }

        /// <summary>Share of the span at which the middle of a strip's patches lies.</summary>
        public static float Middle(int strip, int strips) => (strip + 0.5f) / strips;

        /// <summary>Moves the patches to a time.</summary>
        /// <param name="beats">Time, beats.</param>
        public void Place(double beats)
        {
            m_Motion.Evaluate(beats, m_Places, m_Corners, m_Velocities);
            for (int row = 0; row < m_Rows; row++)
            {
                float3 turning = 0.5f * (Turning(row) + Turning(row + 1));
                for (int i = 0; i < k_Across; i++)
                    All[row * k_Across + i] = Patch(Corner(row, i), turning);
            }
        }

        private float3 Turning(int row) => 0.25f * (m_Velocities[Corner(row, 0)] - m_Velocities[Corner(row, k_Across)]);

        private static int Corner(int row, int i) => row * (k_Across + 1) + i;

        // The span is across the chord, not along a row of patches: on a broad wing the middles of the chords lie on a slanted line.
        private WingPatch Patch(int corner, float3 turning)
        {
            int behind = corner + 1, outer = corner + k_Across + 1, opposite = outer + 1;
            float3 a = m_Corners[corner], b = m_Corners[behind], c = m_Corners[outer], d = m_Corners[opposite];
            float3 vector = 0.5f * math.cross(b - c, d - a), normal = math.normalizesafe(vector);
            return new WingPatch
            {
                place = 0.25f * (a + b + c + d),
                motion = 0.25f * (m_Velocities[corner] + m_Velocities[behind] + m_Velocities[outer] + m_Velocities[opposite]),
                turning = turning,
                normal = normal,
                span = math.normalizesafe(math.cross(normal, b + d - a - c)),
                area = math.length(vector),
            };
        }
    }
}
