using System;
using System.Collections.Generic;

namespace Alate.Flight
{
    /// <summary>
    /// Makes the trim table of an insect: trims, their bobs, the gains, and a second round from where the insect really flies by them.
    /// </summary>
    public sealed class TrimBake
    {
        /// <summary>Speeds and climbs of a table, m/s.</summary>
        public static readonly IReadOnlyList<float> DefaultSpeeds = new[] { 0f, 0.15f, 0.3f, 0.65f, 1f, 1.3f },
            DefaultClimbs = new[] { -0.3f, -0.15f, 0f, 0.3f };

        /// <summary>Rounds in which points that did not close are tried from neighbours that did.</summary>
        private const int k_Rounds = 3;

        /// <summary>Cost of a trim that needs no other one to be looked for.</summary>
        private const double k_Fair = 6;

        private static readonly (int, int)[] s_Neighbours = { (0, -1), (0, 1), (1, 0), (-1, 0) };

        private readonly FlightModel m_Model;

        /// <param name="model">The insect.</param>
        public TrimBake(FlightModel model) => m_Model = model;

        /// <summary>Receiver of the progress, a line a point; null for none.</summary>
        public Action<string> Log { get; set; }

        /// <summary>Wakes whose air the wings meet, each in its own trim; null for air at rest.</summary>
        public ITrimWake Wake { get; set; }

        /// <summary>Makes the table.</summary>
        /// <returns>The table; null where the insect holds no point, see <see cref="Problem"/>.</returns>
        public TrimTable Bake(IReadOnlyList<float> speeds = null, IReadOnlyList<float> climbs = null)
        {
            var table = new TrimTable(Copy(speeds ?? DefaultSpeeds), Copy(climbs ?? DefaultClimbs));
            Problem = null;
            try
            {
                return Fill(table);
            }
            catch
            {
                // Whoever reads the log may stop the bake.
                table.Dispose();
                throw;
            }
        }

        private TrimTable Fill(TrimTable table)
        {
            using var solver = new TrimSolver(m_Model);
            using var tunnel = new FlightTunnel(m_Model, BeatMap.Insects);
            TrimState[,] trims = Trims(solver, table);
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                for (int c = 0; c < table.ClimbRates.Length; c++)
                {
                    if (trims[s, c] != null)
                        Add(table, s, c, new FlightCondition(table.Speeds[s], table.ClimbRates[c]), trims[s, c], tunnel);
                }
            }

            if (!table.Fill())
            {
                table.Dispose();
                return null;
            }

            TableFlight.Check(m_Model, table, Log);
            table.Fill();
            return Refine(table, solver, tunnel);
        }

        /// <summary>Adds speeds where the trims of two do not mix well.</summary>
        internal TrimTable Refine(TrimTable table, TrimSolver solver, FlightTunnel tunnel) =>
            new TableRefinement(
                m_Model.Frequency, (condition, near) => Nearest(solver, condition, near),
                (of, condition) => TableFlight.Mixes(m_Model, of, condition),
                (to, s, c, trim) => Add(to, s, c, new FlightCondition(to.Speeds[s], to.ClimbRates[c]), trim, tunnel))
                .Refine(table);

        private TrimState Nearest(TrimSolver solver, in FlightCondition condition, TrimState near)
        {
            solver.Near = near;
            TrimState trim = solver.Solve(condition, near, out double[] residual);
            solver.Near = null;
            if (TrimSolver.Norm(residual) < TrimSolver.Closed)
                return trim;
            Log?.Invoke(solver.Missing(condition, residual));
            return null;
        }

        /// <summary>
        /// Trims over speeds and climbs in the air of their wakes, each also tried from its neighbours'; null where none closes.
        /// </summary>
        internal TrimState[,] Trims(TrimSolver solver, TrimTable table)
        {
            TrimState[,] trims = Still(solver, table);
            if (Wake != null)
                MeetWakes(new WakeTrims(m_Model, Wake, solver), table, trims);
            return trims;
        }

        private TrimState[,] Still(TrimSolver solver, TrimTable table)
        {
            int speeds = table.Speeds.Length, climbs = table.ClimbRates.Length;
            var trims = new TrimState[speeds, climbs];
            string[,] problems = new string[speeds, climbs];
            bool again = true;
            for (int round = 0; round < k_Rounds && again; round++)
            {
                again = false;
                for (int s = 0; s < speeds; s++)
                {
                    foreach (int c in FromLevel(table.ClimbRates))
                    {
                        if ((trims[s, c] == null
                            || round == 1 && solver.Cost(trims[s, c], new FlightCondition(table.Speeds[s], table.ClimbRates[c])) > k_Fair)
                            && Close(solver, table, trims, problems, s, c, round))
                        {
                            again = true;
                        }
                    }
                }
            }

            Problems = problems;
            foreach (string problem in problems)
            {
                Problem = problem ?? Problem;
                if (problem != null)
                    Log?.Invoke(problem);
            }

            return trims;
        }

        // From level flight outwards and from the fastest to the slowest: each starts from the trim next to it that has met its wake, whose
        // air it takes where its own wake is another one in each beat.
        private void MeetWakes(WakeTrims wakes, TrimTable table, TrimState[,] still)
        {
            var met = new TrimState[table.Speeds.Length, table.ClimbRates.Length];
            foreach (int c in FromLevel(table.ClimbRates))
            {
                int inner = c + Math.Sign(table.LevelClimb - c);
                for (int s = table.Speeds.Length - 1; s >= 0; s--)
                {
                    var condition = new FlightCondition(table.Speeds[s], table.ClimbRates[c]);
                    var beside = new List<(FlightCondition, TrimState)>();
                    foreach ((int ns, int nc) in new[] { (s, inner), (s + 1, c) })
                    {
                        if (ns < table.Speeds.Length && met[ns, nc] != null)
                            beside.Add((new FlightCondition(table.Speeds[ns], table.ClimbRates[nc]), met[ns, nc]));
                    }

                    met[s, c] = wakes.Meet(condition, still[s, c], beside, Log);
                    Problems[s, c] = met[s, c] != null ? null : Problems[s, c] ?? $"{condition}: does not close in the air of its wake.";
                }
            }

            Array.Copy(met, still, met.Length);
            Problem = null;
            foreach (string problem in Problems)
                Problem = problem ?? Problem;
        }

        private static bool Close(TrimSolver solver, TrimTable table, TrimState[,] trims, string[,] problems, int s, int c, int round)
        {
            var condition = new FlightCondition(table.Speeds[s], table.ClimbRates[c]);
            var starts = new List<TrimState>();
            if (round == 0)
            {
                starts.Add(solver.Start());
                starts.Add(TrimState.Tilted());
            }

            foreach ((int ds, int dc) in s_Neighbours)
            {
                int ns = s + ds, nc = c + dc;
                if (ns >= 0 && nc >= 0 && ns < trims.GetLength(0) && nc < trims.GetLength(1) && trims[ns, nc] != null)
                    starts.Add(trims[ns, nc]);
            }

            double least = trims[s, c] == null ? double.PositiveInfinity : solver.Cost(trims[s, c], condition);
            foreach (TrimState start in starts)
            {
                TrimState trim = solver.Solve(condition, start, out double[] residual);
                if (!(TrimSolver.Norm(residual) < TrimSolver.Closed))
                {
                    problems[s, c] ??= solver.Missing(condition, residual);
                    continue;
                }

                double cost = solver.Cost(trim, condition);
                if (!(cost < least))
                    continue;
                least = cost;
                trims[s, c] = trim;
                if (cost < k_Fair)
                    break;
            }

            if (trims[s, c] != null)
                problems[s, c] = null;
            return trims[s, c] != null;
        }

        /// <summary>[speed, climb] Description of what is missing at each point of the last trims; null where it closes.</summary>
        internal string[,] Problems { get; private set; }

        /// <summary>Description of what is missing at a point that does not close or hold the insect; null where all do.</summary>
        public string Problem { get; private set; }

        private void Miss(string problem)
        {
            Problem ??= problem;
            Log?.Invoke(problem);
        }

        private void Add(TrimTable table, int s, int c, in FlightCondition condition, TrimState trim, FlightTunnel tunnel)
        {
            float[] point = Gains(trim, condition, tunnel);
            if (point == null)
            {
                Miss($"{condition}: no gains hold the insect.");
                return;
            }

            for (int round = 0; round < 2; round++)
            {
                TrimState flown = FlownTrim.Fly(m_Model, point, trim, condition, out string lost);
                if (flown == null)
                {
                    if (round == 0)
                    {
                        Miss($"{condition}: {lost}");
                        return;
                    }

                    Log?.Invoke($"{condition}: {lost}");
                    break;
                }

                float[] better = Gains(flown, condition, tunnel);
                if (better == null)
                    break;
                trim = flown;
                point = better;
            }

            table.Set(s, c, point);
            Log?.Invoke(FormattableString.Invariant(
                $"{condition}: pitch {Degrees(trim.Pitch):0.0}° ±{Degrees(trim.PitchBob):0.0}°, ")
                + FormattableString.Invariant($"{trim.FrequencyScale * m_Model.Frequency:0.00} Hz, amplitude {trim.AmplitudeScale:0.000}, ")
                + FormattableString.Invariant($"tilt {Degrees(trim.Tilt):0.0}°, sweep {Degrees(trim.MeanSweep):0.0}°"));
        }

        private float[] Gains(TrimState trim, in FlightCondition condition, FlightTunnel tunnel)
        {
            float[] point = new float[TrimPoint.Floats];
            trim.Write(point, m_Model.Frequency);
            return FlightGains.Write(BeatMap.Fly(tunnel, m_Model, trim, condition), point) ? point : null;
        }

        private static IEnumerable<int> FromLevel(float[] climbs)
        {
            var order = new List<int>();
            for (int k = 0; k < climbs.Length; k++)
                order.Add(k);
            order.Sort((a, b) => Math.Abs(climbs[a]).CompareTo(Math.Abs(climbs[b])));
            return order;
        }

        private static float[] Copy(IReadOnlyList<float> list)
        {
            float[] copy = new float[list.Count];
            for (int k = 0; k < copy.Length; k++)
                copy[k] = list[k];
            Array.Sort(copy);
            return copy;
        }

        private static double Degrees(double radians) => radians * 180 / Math.PI;
    }
}
