using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Extended unsteady vortex lattice (Katz and Plotkin 2001, ch. 13; Nguyen, Kim, Han and Han 2016): no air crosses the panels; forces
    /// by pressure, Δp = ρ (V · ∇Γ + ∂Γ/∂t), and by the suction of the leading edge, which leaves the edge with the vortex above it and
    /// turns into the normal (Polhamus 1966).
    /// </summary>
    internal sealed class PanelSolver : IWingSolver
    {
        /// <summary>Least cosine of the sweep by which the turned suction is divided.</summary>
        private const float k_LeastCosine = 0.5f;

        /// <summary>Share of a panel's chord at which its force acts.</summary>
        private const float k_ForceShare = 0.25f;

        private readonly WakeSettings m_Settings;
        private readonly WingState[] m_Wings;
        private readonly int[] m_First;
        private readonly RingInfluences m_Influences;
        private readonly LinearSystem m_System;
        private readonly float[] m_Circulation;

        // [panel · count + ring] Velocity by a ring of unit circulation of another wing or by mirror images.
        private readonly float3[] m_Others;
        private readonly double m_Factor;

        public PanelSolver(WakeSettings settings, WingState[] wings, int[] first)
        {
            m_Settings = settings;
            m_Wings = wings;
            m_First = first;
            m_Influences = new RingInfluences(first, settings.Images, settings.OnOneThread);
            int count = first[wings.Length];
            m_System = new LinearSystem(count);
            m_Circulation = new float[count];
            m_Others = new float3[count * count];
            m_Factor = LeadingEdge.Factor(settings.ChordPanels);
        }

        public void Dispose() => m_Influences.Dispose();

        public bool Solve(VortexField wake, int steps)
        {
            MeetWake(wake);
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                WingLattice lattice = m_Wings[wing].Lattice;
                m_Influences.SetRings(wing, lattice, m_Wings[wing].Cores, true);
                for (int ring = 0; ring < lattice.RingCount; ring++)
                    m_Influences.SetPoint(wing, ring, lattice.Controls[ring]);
            }

            m_Influences.Evaluate();
            bool solved = SolveCirculation();
            for (int wing = 0; wing < m_Wings.Length; wing++)
                Load(wing, steps);
            return solved;
        }

        // Velocities of the wake at the controls.
        private void MeetWake(VortexField wake)
        {
            wake.SetPointCount(m_First[m_Wings.Length]);
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int ring = 0; ring < m_Wings[wing].Lattice.RingCount; ring++)
                    wake.SetPoint(m_First[wing] + ring, m_Wings[wing].Lattice.Controls[ring]);
            }

            wake.Induce();
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int ring = 0; ring < m_Wings[wing].Lattice.RingCount; ring++)
                    m_Wings[wing].Induced[ring] = wake.Velocity(m_First[wing] + ring);
            }
        }

        private bool SolveCirculation()
        {
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                WingLattice lattice = m_Wings[wing].Lattice;
                for (int ring = 0; ring < lattice.RingCount; ring++)
                {
                    int row = m_First[wing] + ring;
                    float3 normal = lattice.Normals[ring];
                    for (int source = 0; source < m_System.Size; source++)
                    {
                        float3 velocity = m_Influences.Velocity(wing, ring, source, out float3 own);
                        m_System.Set(row, source, math.dot(velocity, normal));
                        m_Others[row * m_System.Size + source] = velocity - own;
                    }

                    m_System.SetRight(row, -math.dot(m_Settings.Stream + m_Wings[wing].Induced[ring] - lattice.Motions[ring], normal));
                }
            }

            bool solved = m_System.Solve(m_Circulation);
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                solved &= m_Wings[wing].Bound(m_Circulation.AsSpan(m_First[wing], m_Wings[wing].Lattice.RingCount), m_Settings.Stream);
                Array.Copy(m_Circulation, m_First[wing], m_Wings[wing].Lattice.Circulation, 0, m_Wings[wing].Lattice.RingCount);
            }

            return solved;
        }

        private void Load(int wing, int steps)
        {
            WingState state = m_Wings[wing];
            WingLattice lattice = state.Lattice;
            state.BeginLoads();
            for (int i = 0; i < lattice.ChordPanels; i++)
            {
                for (int j = 0; j < lattice.SpanPanels; j++)
                {
                    int ring = lattice.Ring(i, j);
                    state.Induced[ring] += OfOthers(m_First[wing] + ring);
                    float3 stream = m_Settings.Stream + state.Induced[ring] - lattice.Motions[ring];
                    float3 force = Pressure(lattice, i, j, stream, Growth(lattice, ring, steps)) * lattice.Normals[ring];
                    if (i == 0)
                        force += Suction(lattice, j, stream);
                    float3 motion = lattice.AtPanel(lattice.CornerVelocities, i, j, k_ForceShare);
                    float area = math.length(math.cross(lattice.Chordwise(i, j), lattice.Spanwise(i, j)));
                    state.AddLoad(j, new WingLoad
                    {
                        place = lattice.AtPanel(lattice.Corners, i, j, k_ForceShare),
                        motion = motion,
                        force = force,
                        inflow = state.Induced[ring],
                        weight = area * math.length(m_Settings.Stream - motion),
                    });
                }
            }

            state.EndLoads();
        }

        private float3 OfOthers(int panel)
        {
            float3 sum = default;
            for (int source = 0; source < m_System.Size; source++)
                sum += m_Circulation[source] * m_Others[panel * m_System.Size + source];
            return sum;
        }

        // Pressure times area, over ρ. The gradient of Γ in the reciprocal basis: panels are skew.
        private float Pressure(WingLattice lattice, int i, int j, float3 stream, float growth)
        {
            float3 chord = lattice.Chordwise(i, j), span = lattice.Spanwise(i, j), normal = lattice.Normals[lattice.Ring(i, j)];
            float here = lattice.Circulation[lattice.Ring(i, j)];
            float along = here - (i > 0 ? lattice.Circulation[lattice.Ring(i - 1, j)] : 0f);
            float outer = j < lattice.SpanPanels - 1 ? lattice.Circulation[lattice.Ring(i, j + 1)] : 0f;
            float inner = j > 0 ? lattice.Circulation[lattice.Ring(i, j - 1)] : lattice.FreeRoot ? 0f : here;
            float3 across = math.cross(span, normal);
            float volume = math.dot(across, chord);
            if (math.abs(volume) < 1e-12f)
                return 0f;
            float3 gradient = (across * along + math.cross(normal, chord) * (0.5f * (outer - inner))) / volume;
            return (math.dot(stream, gradient) + growth) * math.length(math.cross(chord, span));
        }

        // ∂Γ/∂t by three moments; by two in the second step, none in the first.
        private float Growth(WingLattice lattice, int ring, int steps)
        {
            float now = lattice.Circulation[ring], before = lattice.Before[ring], longBefore = lattice.LongBefore[ring];
            float change = steps == 0 ? 0f : steps == 1 ? now - before : 1.5f * now - 2f * before + 0.5f * longBefore;
            return change * m_Settings.StepsPerBeat;
        }

        private float3 Suction(WingLattice lattice, int j, float3 stream)
        {
            float suction = LeadingEdge.Suction(lattice, j, m_Factor, out float cosine);
            float3 normal = lattice.Normals[lattice.Ring(0, j)];
            float3 edge = lattice.Corners[lattice.Corner(0, j + 1)] - lattice.Corners[lattice.Corner(0, j)];
            if (m_Settings.SuctionAlongChord)
            {
                // Ahead of the edge, across it, in the panel's plane.
                float3 ahead = math.normalizesafe(math.cross(edge, normal));
                return suction * math.sign(-math.dot(ahead, lattice.Chordwise(0, j))) * ahead;
            }

            float side = math.sign(math.dot(math.cross(stream, edge), normal) * lattice.Circulation[lattice.Ring(0, j)]);
            return m_Settings.TurnedSuction * side * suction / math.max(cosine, k_LeastCosine) * normal;
        }
    }
}
