using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>A wing with its wake, and its loads at a moment. Forces are over ρ, in reference lengths⁴ a squared beat.</summary>
    internal sealed class WingState
    {
        /// <summary>
        /// Largest circulation over that of a flat plate across the fastest air that the wing meets, π c V: wings that touch their mirror
        /// images or cross their own wakes have no other bound.
        /// </summary>
        private const float k_MostCirculation = 10f;

        private readonly WakeSection[] m_Sections;

        // [strip] Sums of the loads so far; their inflow is times the weight.
        private readonly WingLoad[] m_Sums;
        private float3 m_Moment;
        private float m_Power;

        public WingState(WakeWing wing, WakeSettings settings)
        {
            Wing = wing;
            Lattice = new WingLattice(wing, settings);
            Cores = new WakeCores(settings, Lattice.MeanChord);
            Sheet = new VortexSheet(settings.SpanPanels, settings.Rows, Cores);
            Induced = new float3[Lattice.RingCount];
            m_Sections = new WakeSection[settings.SpanPanels];
            m_Sums = new WingLoad[settings.SpanPanels];
            Patches = settings.Method == WakeMethod.Strips ? new WingPatches(wing.Motion, settings.SpanPanels) : null;
        }

        public WakeWing Wing { get; }
        public WingLattice Lattice { get; }
        public WakeCores Cores { get; }
        public VortexSheet Sheet { get; }

        /// <summary>Patches that meet the air of strips; null for panels.</summary>
        public WingPatches Patches { get; }

        /// <summary>
        /// [ring] Velocity of the air that all vortices but the wing's own rings have set moving, where the panel meets it.
        /// </summary>
        public float3[] Induced { get; }

        /// <summary>Their sums.</summary>
        public WakeLoads Loads { get; private set; }

        /// <summary>Writes the segments of the wing's rings as the wake feels them.</summary>
        public void WriteBound(VortexField field)
        {
            WingLattice lattice = Lattice;
            int n = lattice.ChordPanels, m = lattice.SpanPanels;
            for (int i = 0; i <= n; i++)
            {
                field.Begin(lattice.Rings[lattice.Corner(i, 0)]);
                for (int j = 0; j < m; j++)
                {
                    float circulation = (i < n ? lattice.Circulation[lattice.Ring(i, j)] : 0f)
                        - (i > 0 ? lattice.Circulation[lattice.Ring(i - 1, j)] : 0f);
                    field.Add(lattice.Rings[lattice.Corner(i, j + 1)], circulation, i == n ? Cores.Shed : Cores.Bound);
                }
            }

            for (int j = 0; j <= m; j++)
            {
                field.Begin(lattice.Rings[lattice.Corner(0, j)]);
                for (int i = 0; i < n; i++)
                {
                    float circulation = (j > 0 ? lattice.Circulation[lattice.Ring(i, j - 1)] : 0f)
                        - (j < m ? lattice.Circulation[lattice.Ring(i, j)] : 0f);
                    field.Add(lattice.Rings[lattice.Corner(i + 1, j)], circulation, Cores.Bound);
                }
            }
        }

        /// <summary>Clamps the circulation of the wing's rings; what is no number becomes 0.</summary>
        /// <param name="circulation">[ring]</param>
        /// <param name="stream">Velocity of the air.</param>
        /// <returns>False where the bound acts.</returns>
        public bool Bound(Span<float> circulation, float3 stream)
        {
            float fastest = 0f;
            foreach (float3 motion in Lattice.Motions)
                fastest = math.max(fastest, math.length(stream - motion));
            float most = k_MostCirculation * math.PI * Lattice.MeanChord * fastest;
            bool holds = true;
            foreach (ref float ring in circulation)
            {
                holds &= math.abs(ring) <= most;
                ring = math.isnan(ring) ? 0f : math.clamp(ring, -most, most);
            }

            return holds;
        }

        /// <summary>Begins the sums of the loads of a moment.</summary>
        public void BeginLoads()
        {
            m_Power = 0f;
            m_Moment = default;
            Array.Clear(m_Sums, 0, m_Sums.Length);
        }

        /// <summary>Adds a load to those of a strip.</summary>
        public void AddLoad(int strip, in WingLoad load)
        {
            m_Moment += math.cross(load.place, load.force);
            m_Power -= math.dot(load.force, load.motion);
            m_Sums[strip].force += load.force;
            m_Sums[strip].inflow += load.weight * load.inflow;
            m_Sums[strip].weight += load.weight;
        }

        /// <summary>Ends the sums.</summary>
        public void EndLoads()
        {
            WingLoad whole = default;
            for (int j = 0; j < m_Sums.Length; j++)
            {
                WingLoad sum = m_Sums[j];
                whole.force += sum.force;
                whole.inflow += sum.inflow;
                whole.weight += sum.weight;
                m_Sections[j] = new WakeSection(Patches == null ? Lattice.Middle(j) : WingPatches.Middle(j, m_Sums.Length),
                    Lattice.Circulation[Lattice.Ring(Lattice.ChordPanels - 1, j)], sum.force, sum.MeanInflow);
            }

            Loads = new WakeLoads(whole.force, m_Moment, m_Power, whole.MeanInflow);
        }

        /// <summary>Loads of a strip, of those from the root to the tip.</summary>
        public WakeSection Section(int strip) => m_Sections[strip];
    }
}
