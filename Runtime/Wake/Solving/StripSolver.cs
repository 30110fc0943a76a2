using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Nonlinear lifting line: the circulation of each strip's ring is that of its lift coefficient in the air that it meets, wake, other
    /// wings and the sides of its own rings included.
    /// </summary>
    internal sealed class StripSolver : IWingSolver
    {
        /// <summary>Share of the largest circulation that may lack: at which it is settled, and up to which the step counts.</summary>
        private const float k_Tolerance = 2e-4f, k_Enough = 0.01f;
        private const float k_SmallStep = 0.1f;
        private const int k_MostPasses = 20, k_MostHalvings = 6, k_MostSmallSteps = 60;

        private readonly WakeSettings m_Settings;
        private readonly WingState[] m_Wings;
        private readonly StripPolar[] m_Polars;
        private readonly int[] m_First;
        private readonly RingInfluences m_Influences;

        // [strip · count + source] Velocity at a strip by a ring of unit circulation.
        private readonly float3[] m_Velocities;
        private readonly float[] m_Circulation, m_Next, m_Wanted, m_Change;
        private readonly float3[] m_Inner;
        private readonly LinearSystem m_System;
        private float m_Tolerance;

        public StripSolver(WakeSettings settings, WingState[] wings, int[] first)
        {
            m_Settings = settings;
            m_Wings = wings;
            m_First = first;
            m_Influences = new RingInfluences(first, settings.Images, settings.OnOneThread);
            int count = first[wings.Length];
            m_Velocities = new float3[count * count];
            m_Circulation = new float[count];
            m_Next = new float[count];
            m_Wanted = new float[count];
            m_Change = new float[count];
            m_Inner = new float3[settings.SpanPanels];
            m_System = new LinearSystem(count);
            m_Polars = new StripPolar[wings.Length];
            for (int k = 0; k < wings.Length; k++)
                m_Polars[k] = new StripPolar(wings[k].Wing.Coefficients, wings[k].Wing.Downwash);
        }

        public void Dispose() => m_Influences.Dispose();

        public bool Solve(VortexField wake, int steps)
        {
            MeetWake(wake);
            Influence();
            bool settled = Iterate();
            for (int wing = 0; wing < m_Wings.Length; wing++)
                Load(wing);
            return settled;
        }

        private static float3 Middle(WingLattice lattice, int j) =>
            0.5f * (lattice.Rings[lattice.Corner(0, j)] + lattice.Rings[lattice.Corner(0, j + 1)]);

        private void MeetWake(VortexField wake)
        {
            wake.SetPointCount(m_First[m_Wings.Length]);
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                    wake.SetPoint(m_First[wing] + j, Middle(m_Wings[wing].Lattice, j));
            }

            wake.Induce();
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                    m_Wings[wing].Induced[j] = wake.Velocity(m_First[wing] + j);
            }
        }

        private void Influence()
        {
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                WingLattice lattice = m_Wings[wing].Lattice;
                m_Influences.SetRings(wing, lattice, m_Wings[wing].Cores, false);
                for (int j = 0; j < lattice.SpanPanels; j++)
                    m_Influences.SetPoint(wing, j, Middle(lattice, j));
            }

            m_Influences.Evaluate();
            int count = m_Circulation.Length;
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                {
                    for (int source = 0; source < count; source++)
                        m_Velocities[(m_First[wing] + j) * count + source] = m_Influences.Velocity(wing, j, source, out _);
                }
            }
        }

        // Newton's method, with steps halved while they make it worse: near the tip a strip answers to its own trailing legs by several
        // times what it has, which simple passes do not stand. Where a strip's polar has a kink Newton's steps may go to and fro: small
        // steps then.
        private bool Iterate()
        {
            float lack = Lack(m_Circulation);
            for (int pass = 0; pass < k_MostPasses && lack > m_Tolerance; pass++)
            {
                Linearise();
                if (!m_System.Solve(m_Change))
                    break;
                float share = 1f, before = lack;
                for (int halving = 0; halving < k_MostHalvings; halving++, share *= 0.5f)
                {
                    for (int strip = 0; strip < m_Next.Length; strip++)
                        m_Next[strip] = m_Circulation[strip] + share * m_Change[strip];
                    lack = Lack(m_Next);
                    if (lack < before)
                        break;
                }

                System.Array.Copy(m_Next, m_Circulation, m_Next.Length);
            }

            for (int pass = 0; pass < k_MostSmallSteps && lack > m_Tolerance; pass++)
            {
                for (int strip = 0; strip < m_Circulation.Length; strip++)
                    m_Circulation[strip] += k_SmallStep * (m_Wanted[strip] - m_Circulation[strip]);
                lack = Lack(m_Circulation);
            }

            return lack <= k_Enough / k_Tolerance * m_Tolerance;
        }

        // Largest difference between a circulation and the one that its lift asks for; sets the size that counts as none.
        private float Lack(float[] circulation)
        {
            float largest = 0f, lack = 0f;
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                {
                    int strip = m_First[wing] + j;
                    float3 stream = Stream(wing, j, circulation, out _);
                    m_Wanted[strip] = Wanted(Meet(wing, j, stream));
                    lack = math.max(lack, math.abs(m_Wanted[strip] - circulation[strip]));
                    largest = math.max(largest, math.abs(m_Wanted[strip]));
                }
            }

            m_Tolerance = k_Tolerance * math.max(largest, 1e-9f);
            return lack;
        }

        // Equations of the change that makes up for the lack, by differences of what the lift asks for in a changed stream.
        private void Linearise()
        {
            int count = m_Circulation.Length;
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                {
                    int strip = m_First[wing] + j;
                    float3 stream = Stream(wing, j, m_Circulation, out _);
                    StripAir air = Meet(wing, j, stream);
                    float step = 1e-3f * math.length(air.stream) + 1e-9f, now = Wanted(air);
                    float3 gradient =
                        (Wanted(Meet(wing, j, stream + step * air.normal)) - Wanted(Meet(wing, j, stream - step * air.normal)))
                            / (2f * step) * air.normal
                        + (Wanted(Meet(wing, j, stream + step * air.chord)) - Wanted(Meet(wing, j, stream - step * air.chord)))
                            / (2f * step) * air.chord;
                    for (int source = 0; source < count; source++)
                        m_System.Set(strip, source, (source == strip ? 1f : 0f) - math.dot(gradient, m_Velocities[strip * count + source]));
                    m_System.SetRight(strip, now - m_Circulation[strip]);
                }
            }
        }

        private static float Wanted(in StripAir air)
        {
            float3 turn = math.cross(air.stream, air.leg);
            return math.dot(air.lift, turn) / math.max(math.lengthsq(turn), 1e-12f);
        }

        private void Load(int wing)
        {
            WingState state = m_Wings[wing];
            for (int j = 0; j < state.Lattice.SpanPanels; j++)
            {
                StripAir air = Meet(wing, j, Stream(wing, j, m_Circulation, out m_Inner[j]));
                state.Lattice.Circulation[j] = m_Circulation[m_First[wing] + j];
                state.Forces[j] = air.lift + air.drag;
                m_Inner[j] = Outer(air, m_Inner[j]);
            }

            for (int j = 0; j < state.Lattice.SpanPanels; j++)
                state.Induced[j] = m_Inner[j];
            state.SumUp(m_Settings.Stream, 0.5f);
        }

        // Velocity of the air that vortices have set moving, as the coefficients count it: what they hold of it is taken out.
        private static float3 Outer(in StripAir air, float3 induced)
        {
            float angle = air.outer - air.angle;
            float side = math.sign(math.dot(air.stream, air.normal)) * math.sign(math.dot(air.stream, air.chord));
            float3 across = math.cross(math.cross(air.chord, air.normal), air.stream);
            float3 turned = math.cos(angle) * air.stream + math.sin(angle) * side * across;
            return turned - air.stream + induced;
        }

        // The air at a strip, with circulations of this pass.
        private float3 Stream(int wing, int j, float[] circulation, out float3 induced)
        {
            int count = circulation.Length, strip = m_First[wing] + j;
            induced = m_Wings[wing].Induced[j];
            for (int source = 0; source < count; source++)
                induced += circulation[source] * m_Velocities[strip * count + source];
            return m_Settings.Stream + induced - m_Wings[wing].Lattice.AtPanel(m_Wings[wing].Lattice.CornerVelocities, 0, j, 0.5f);
        }

        // What a strip makes of the air that it meets.
        private StripAir Meet(int wing, int j, float3 stream)
        {
            WingLattice lattice = m_Wings[wing].Lattice;
            float3 spanwise = lattice.Spanwise(0, j), chordwise = lattice.Chordwise(0, j);
            float3 span = math.normalizesafe(spanwise), chord = math.normalizesafe(chordwise - math.dot(chordwise, span) * span);
            stream -= math.dot(stream, span) * span;
            float3 normal = lattice.Normals[j];
            float across = math.dot(stream, normal), square = math.lengthsq(stream);
            var air = new StripAir
            {
                stream = stream,
                normal = normal,
                chord = chord,
                leg = lattice.Rings[lattice.Corner(0, j + 1)] - lattice.Rings[lattice.Corner(0, j)],
                angle = math.atan2(math.abs(across), math.abs(math.dot(stream, chord))),
            };
            if (square < 1e-12f)
                return air;
            m_Polars[wing].Evaluate(air.angle, out float lift, out float drag, out air.outer);
            float half = 0.5f * math.length(math.cross(chordwise, spanwise));
            float3 along = stream * math.rsqrt(square), up = math.normalizesafe(normal - math.dot(normal, along) * along);
            air.lift = half * square * lift * math.sign(across) * up;
            air.drag = half * square * drag * along;
            return air;
        }

        // Air that a strip meets, without its part along the span.
        private struct StripAir
        {
            public float3 stream, normal, chord, leg, lift, drag;

            /// <summary>Angle between chord and stream, and that without the downwash which the coefficients hold, radians.</summary>
            public float angle, outer;
        }
    }
}
