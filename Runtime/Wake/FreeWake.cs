using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Wings that shed a free wake of vortex rings, step by step: the wake moves with the air that all vortices set moving, and the wings
    /// meet that air. Lengths are reference lengths, times beats, forces over the density of the fluid.
    /// </summary>
    public sealed class FreeWake : IDisposable
    {
        private readonly WakeSettings m_Settings;
        private readonly WingState[] m_Wings;
        private readonly VortexField m_Field;
        private readonly IWingSolver m_Solver;

        /// <summary>Takes the memory of a wake; nothing has moved yet.</summary>
        /// <param name="settings">Numbers of the wake; later changes do nothing.</param>
        /// <param name="wings">Wings; the right ones alone where the settings are symmetric.</param>
        /// <exception cref="ArgumentException">A number is out of its range, or a wing has no area.</exception>
        public FreeWake(WakeSettings settings, IReadOnlyList<WakeWing> wings)
        {
            settings.Validate(wings.Count);
            settings = settings.Copy();
            m_Settings = settings;
            m_Wings = new WingState[wings.Count];
            int[] first = new int[wings.Count + 1];
            int vertices = 0, points = 0;
            for (int k = 0; k < wings.Count; k++)
            {
                m_Wings[k] = new WingState(wings[k], settings);
                first[k + 1] = first[k] + m_Wings[k].Lattice.RingCount;
                vertices += m_Wings[k].Sheet.MostVertices + 2 * (settings.ChordPanels + 1) * (settings.SpanPanels + 1);
                points += settings.Rows * (settings.SpanPanels + 1);
            }

            m_Field = new VortexField(vertices, math.max(points, first[wings.Count]), settings.Images, settings.OnOneThread);
            m_Solver = settings.Method == WakeMethod.Panels
                ? new PanelSolver(settings, m_Wings, first)
                : new StripSolver(settings, m_Wings, first);
        }

        /// <summary>Time of the next step, beats.</summary>
        public double Time => (double)StepCount / m_Settings.StepsPerBeat;

        /// <summary>Number of steps done.</summary>
        public int StepCount { get; private set; }

        /// <summary>Number of steps in which the wings had no circulation that fits.</summary>
        public int Failures { get; private set; }

        /// <summary>Number of influences of segments on points of the wake and the wings.</summary>
        public long Influences => m_Field.Influences;

        /// <summary>Number of wings.</summary>
        public int WingCount => m_Wings.Length;

        internal IReadOnlyList<WingState> Wings => m_Wings;

        /// <summary>Loads of the air on a wing in the last step.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        public WakeLoads Loads(int wing)
        {
            Check(wing);
            return m_Wings[wing].Loads;
        }

        /// <summary>Number of strips of a wing, from its root to its tip.</summary>
        public int SectionCount => m_Settings.SpanPanels;

        /// <summary>Loads of the air on a strip of a wing in the last step.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing or strip.</exception>
        public WakeSection Section(int wing, int strip)
        {
            Check(wing);
            if (strip < 0 || strip >= SectionCount)
                throw new ArgumentOutOfRangeException(nameof(strip), strip, $"There are {SectionCount} strips, from 0.");
            return m_Wings[wing].Section(strip);
        }

        /// <summary>Wake of a wing at the moment of the last step; read it before the next one.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        public WakeSheet Sheet(int wing)
        {
            Check(wing);
            return new WakeSheet(m_Wings[wing].Sheet);
        }

        /// <summary>
        /// Computes the velocities that the vortices of all wings and wakes have given to the air at the moment of the last step; the
        /// stream is not in them.
        /// </summary>
        /// <param name="points">Places; any number.</param>
        /// <param name="velocities">[point] Reference lengths a beat.</param>
        /// <exception cref="ArgumentException">There are more places than velocities.</exception>
        /// <exception cref="InvalidOperationException">No step has been done.</exception>
        public void Velocities(ReadOnlySpan<float3> points, Span<float3> velocities)
        {
            if (points.Length > velocities.Length)
                throw new ArgumentException($"{points.Length} points need as many velocities; there are {velocities.Length}.");
            if (StepCount == 0)
                throw new InvalidOperationException("A wake induces nothing before its first step.");
            for (int first = 0; first < points.Length; first += m_Field.PointCapacity)
            {
                int count = math.min(m_Field.PointCapacity, points.Length - first);
                m_Field.SetPointCount(count);
                for (int k = 0; k < count; k++)
                    m_Field.SetPoint(k, points[first + k]);
                m_Field.Induce();
                for (int k = 0; k < count; k++)
                    velocities[first + k] = m_Field.Velocity(k);
            }
        }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            m_Field.Dispose();
            m_Solver.Dispose();
        }

        /// <summary>
        /// Does a step: moves the wake of the step before, places the wings, sheds, solves, and computes the loads. Wings, wake and loads
        /// are those of one moment then.
        /// </summary>
        public void Step()
        {
            if (StepCount > 0)
                MoveWake();
            m_Field.Clear();
            foreach (WingState wing in m_Wings)
            {
                wing.Lattice.Shift();
                wing.Lattice.Place(Time, m_Settings.Stream, m_Settings.Step);
                wing.Patches?.Place(Time);
                wing.Sheet.Shed(wing.Lattice);
                wing.Sheet.Write(m_Field);
            }

            if (!m_Solver.Solve(m_Field, StepCount))
                Failures++;
            foreach (WingState wing in m_Wings)
                wing.WriteBound(m_Field);
            StepCount++;
        }

        private void Check(int wing)
        {
            if (wing < 0 || wing >= m_Wings.Length)
                throw new ArgumentOutOfRangeException(nameof(wing), wing, $"There are {m_Wings.Length} wings, from 0.");
        }

        private void MoveWake()
        {
            int count = 0;
            foreach (WingState wing in m_Wings)
                count += wing.Sheet.PointCount;
            m_Field.SetPointCount(count);
            int first = 0;
            foreach (WingState wing in m_Wings)
            {
                wing.Sheet.WritePoints(m_Field, first);
                first += wing.Sheet.PointCount;
            }

            m_Field.Induce();
            first = 0;
            foreach (WingState wing in m_Wings)
            {
                wing.Sheet.Move(m_Field, first, m_Settings.Stream, m_Settings.Step);
                first += wing.Sheet.PointCount;
            }
        }
    }
}
