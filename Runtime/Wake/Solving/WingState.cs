using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>A wing with its wake, and its loads at a moment. Forces are over ρ, in reference lengths⁴ a squared beat.</summary>
    internal sealed class WingState
    {
        private readonly WakeSection[] m_Sections;

        public WingState(WakeWing wing, WakeSettings settings)
        {
            Wing = wing;
            Lattice = new WingLattice(wing, settings);
            Cores = new WakeCores(settings, Lattice.MeanChord);
            Sheet = new VortexSheet(settings.SpanPanels, settings.Rows, Cores);
            Forces = new float3[Lattice.RingCount];
            Induced = new float3[Lattice.RingCount];
            m_Sections = new WakeSection[settings.SpanPanels];
        }

        public WakeWing Wing { get; }
        public WingLattice Lattice { get; }
        public WakeCores Cores { get; }
        public VortexSheet Sheet { get; }

        /// <summary>[ring] Force on each panel.</summary>
        public float3[] Forces { get; }

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

        /// <summary>Sums up the loads of the panels.</summary>
        /// <param name="stream">Velocity of the air.</param>
        /// <param name="share">Share of each panel's chord at which its force acts.</param>
        public void SumUp(float3 stream, float share)
        {
            float3 force = default, moment = default, inflow = default;
            float power = 0f, weights = 0f;
            for (int j = 0; j < Lattice.SpanPanels; j++)
            {
                float3 onStrip = default, atStrip = default;
                float stripWeights = 0f;
                for (int i = 0; i < Lattice.ChordPanels; i++)
                {
                    int ring = Lattice.Ring(i, j);
                    float3 at = Lattice.AtPanel(Lattice.Corners, i, j, share);
                    float3 moved = Lattice.AtPanel(Lattice.CornerVelocities, i, j, share);
                    onStrip += Forces[ring];
                    moment += math.cross(at, Forces[ring]);
                    power -= math.dot(Forces[ring], moved);
                    float weight = math.lengthsq(stream - moved) * math.length(math.cross(Lattice.Chordwise(i, j), Lattice.Spanwise(i, j)));
                    atStrip += weight * Induced[ring];
                    stripWeights += weight;
                }

                force += onStrip;
                inflow += atStrip;
                weights += stripWeights;
                m_Sections[j] = new WakeSection(
                    Lattice.Middle(j), Lattice.Circulation[Lattice.Ring(Lattice.ChordPanels - 1, j)], onStrip,
                    stripWeights > 0f ? atStrip / stripWeights : default);
            }

            Loads = new WakeLoads(force, moment, power, weights > 0f ? inflow / weights : default);
        }

        /// <summary>Loads of a strip, of those from the root to the tip.</summary>
        public WakeSection Section(int strip) => m_Sections[strip];
    }
}
