using System;
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

        /// <summary>
        /// Cosine of the angle to the air below which the lift falls to nothing: the coefficients have a little at a right angle, where its
        /// direction turns about.
        /// </summary>
        private const float k_Upright = 0.05f;
        private const int k_MostPasses = 20, k_MostHalvings = 6, k_MostSmallSteps = 60;

        private readonly WakeSettings m_Settings;
        private readonly WingState[] m_Wings;
        private readonly StripPolar[] m_Polars;
        private readonly int[] m_First;
        private readonly RingInfluences m_Influences;

        // [strip · count + source] Velocity at a strip by a ring of unit circulation.
        private readonly float3[] m_Velocities;
        private readonly float[] m_Circulation, m_Next, m_Wanted, m_Change;
        private readonly LinearSystem m_System;
        private readonly StalledStrips m_Stalled;
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
            m_System = new LinearSystem(count);
            m_Stalled = new StalledStrips(first);
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
            {
                settled &= m_Wings[wing].Bound(
                    m_Circulation.AsSpan(m_First[wing], m_Wings[wing].Lattice.SpanPanels), m_Settings.Stream);
            }

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
            m_Stalled.Clear();
            float lack = Lack(m_Circulation);
            for (int pass = 0; pass < k_MostPasses && lack > m_Tolerance; pass++)
            {
                if (Linearise())
                    lack = Lack(m_Circulation);
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

                Array.Copy(m_Next, m_Circulation, m_Next.Length);
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
                    m_Wanted[strip] = Wanted(Meet(wing, j, Air(wing, j, circulation))) + m_Stalled.Taken(wing, strip, circulation);
                    lack = math.max(lack, math.abs(m_Wanted[strip] - circulation[strip]));
                    largest = math.max(largest, math.abs(m_Wanted[strip]));
                }
            }

            m_Tolerance = k_Tolerance * math.max(largest, 1e-9f);
            return lack;
        }

        // Equations of the change that makes up for the lack, by differences of what the lift asks for in a changed stream; true where
        // strips are found stalled, or more so than before.
        private bool Linearise()
        {
            int count = m_Circulation.Length;
            bool isMore = false;
            for (int wing = 0; wing < m_Wings.Length; wing++)
            {
                for (int j = 0; j < m_Wings[wing].Lattice.SpanPanels; j++)
                {
                    int strip = m_First[wing] + j;
                    float3 air = Air(wing, j, m_Circulation), normal = m_Wings[wing].Lattice.Normals[j];
                    float3 chord = math.normalizesafe(math.cross(m_Wings[wing].Lattice.Spanwise(0, j), normal));
                    StripAir met = Meet(wing, j, air);
                    float step = 1e-3f * math.length(met.stream) + 1e-9f, now = Wanted(met);
                    float3 gradient =
                        (Wanted(Meet(wing, j, air + step * normal)) - Wanted(Meet(wing, j, air - step * normal))) / (2f * step) * normal
                        + (Wanted(Meet(wing, j, air + step * chord)) - Wanted(Meet(wing, j, air - step * chord))) / (2f * step) * chord;
                    isMore |= m_Stalled.Meet(strip, math.dot(gradient, m_Velocities[strip * count + strip]));
                    for (int source = 0; source < count; source++)
                    {
                        float slope = math.dot(gradient, m_Velocities[strip * count + source]);
                        if (math.abs(source - strip) <= 1)
                            slope += m_Stalled.Slope(wing, strip, source);
                        m_System.Set(strip, source, (source == strip ? 1f : 0f) - slope);
                    }

                    m_System.SetRight(strip, now + m_Stalled.Taken(wing, strip, m_Circulation) - m_Circulation[strip]);
                }
            }

            return isMore;
        }

        // ½ c C_L V: a strip that turns about its middle has lift in the mean of the squares of the speeds, which no circulation carries.
        private static float Wanted(in StripAir air)
        {
            float3 turn = math.cross(air.stream, air.leg);
            float share = math.lengthsq(air.stream) / math.max(air.square, 1e-12f);
            return share * math.dot(air.lift, turn) / math.max(math.lengthsq(turn), 1e-12f);
        }

        private void Load(int wing)
        {
            WingState state = m_Wings[wing];
            state.BeginLoads();
            for (int j = 0; j < state.Lattice.SpanPanels; j++)
            {
                int strip = m_First[wing] + j;
                state.Lattice.Circulation[j] = m_Circulation[strip];
                float3 air = Air(wing, j, m_Circulation);
                for (int k = j * WingPatches.PerStrip; k < (j + 1) * WingPatches.PerStrip; k++)
                {
                    WingPatch patch = state.Patches.All[k];
                    PatchAir met = Meet(wing, patch, air);
                    state.AddLoad(j, new WingLoad
                    {
                        place = patch.place,
                        motion = patch.motion,
                        force = met.lift + met.drag,
                        inflow = air - m_Settings.Stream + met.outer,
                        weight = patch.area * math.length(m_Settings.Stream - patch.motion),
                    });
                }
            }

            state.EndLoads();
        }

        // The air at a strip with circulations of this pass, against the body.
        private float3 Air(int wing, int j, float[] circulation)
        {
            int count = circulation.Length, strip = m_First[wing] + j;
            float3 air = m_Settings.Stream + m_Wings[wing].Induced[j];
            for (int source = 0; source < count; source++)
                air += circulation[source] * m_Velocities[strip * count + source];
            return air;
        }

        // What the patches of a strip make of the air.
        private StripAir Meet(int wing, int j, float3 air)
        {
            WingState state = m_Wings[wing];
            WingLattice lattice = state.Lattice;
            // As long as the patches reach, which is a little farther than the ring does.
            float3 leg = (lattice.Rings[lattice.Corner(0, j + 1)] - lattice.Rings[lattice.Corner(0, j)])
                / (lattice.Width(j) * lattice.SpanPanels);
            var sum = new StripAir { leg = leg };
            float area = 0f;
            for (int k = j * WingPatches.PerStrip; k < (j + 1) * WingPatches.PerStrip; k++)
            {
                WingPatch patch = state.Patches.All[k];
                PatchAir met = Meet(wing, patch, air);
                sum.stream += patch.area * met.stream;
                sum.square += patch.area * math.lengthsq(met.stream);
                sum.lift += met.lift;
                area += patch.area;
            }

            sum.stream /= math.max(area, 1e-12f);
            sum.square /= math.max(area, 1e-12f);
            return sum;
        }

        private PatchAir Meet(int wing, in WingPatch patch, float3 air)
        {
            var met = new PatchAir { stream = air - patch.motion };
            met.stream -= math.dot(met.stream, patch.span) * patch.span;
            float across = math.dot(met.stream, patch.normal), square = math.lengthsq(met.stream);
            if (square < 1e-12f)
                return met;
            if (m_Wings[wing].Wing.AttachedRotation)
            {
                met.stream += (1f - across * across / square) * math.dot(patch.turning, patch.normal) * patch.normal;
                across = math.dot(met.stream, patch.normal);
                square = math.lengthsq(met.stream);
            }

            float speed = math.sqrt(square), angle = math.asin(math.min(math.abs(across) / speed, 1f));
            m_Polars[wing].Evaluate(angle, out float lift, out float drag, out float outer);
            float3 along = met.stream / speed;
            float3 up = math.sign(across) * math.normalizesafe(patch.normal - math.dot(patch.normal, along) * along);
            float firm = math.smoothstep(0f, k_Upright, math.sqrt(math.max(0f, 1f - across * across / square)));
            met.lift = 0.5f * patch.area * square * lift * firm * up;
            met.drag = 0.5f * patch.area * square * drag * along;
            float turn = outer - angle;
            met.outer = (math.cos(turn) - 1f) * met.stream + math.sin(turn) * speed * up;
            return met;
        }

        // Air that the patches of a strip meet, in the mean, and the sum of their lift.
        private struct StripAir
        {
            public float3 stream, leg, lift;

            /// <summary>Mean of the squares of the speeds.</summary>
            public float square;
        }

        // Air that a patch meets, without its part along the span.
        private struct PatchAir
        {
            public float3 stream, lift, drag;

            /// <summary>Velocity to add for a stream without the downwash that the coefficients hold.</summary>
            public float3 outer;
        }
    }
}
