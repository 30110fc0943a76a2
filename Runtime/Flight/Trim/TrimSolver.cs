using System;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Finds the beat and attitude that carry an insect steadily: of all that balance lift, thrust and pitching moment the nearest to
    /// preferred ones, within bounds; with the bob of the body that the forces of the beat make.
    /// </summary>
    internal sealed class TrimSolver : IDisposable
    {
        /// <summary>Residual that counts as closed.</summary>
        public const double Closed = 0.005;

        private const int k_Iterations = 24;

        /// <summary>Residual from which on the body bobs, and iterations after which it does anyway.</summary>
        private const double k_Near = 0.03;
        private const int k_Still = 8;

        /// <summary>Most halvings of a move.</summary>
        private const int k_Halvings = 3;

        /// <summary>Weight of the way to where the bob settles beside what is left of the balance.</summary>
        private const double k_BobWeight = 0.1;
        private const double k_Degree = Math.PI / 180;

        private static readonly double[] s_Scales = { 15 * k_Degree, 0.08, 0.10, 15 * k_Degree, 10 * k_Degree };

        private readonly FlightModel m_Model;
        private readonly TrimSystem m_System;

        public TrimSolver(FlightModel model)
        {
            m_Model = model;
            m_System = new TrimSystem(model);
        }

        /// <summary>Trim that solutions stay near to, in place of the preferred beat and attitude; null for none.</summary>
        public TrimState Near { get; set; }

        /// <summary>True where the body is held still: its bob stays that of the start.</summary>
        public bool HoldsStill { get; set; }

        /// <summary>Solves for a condition.</summary>
        /// <param name="condition">Steady flight.</param>
        /// <param name="start">Where to begin.</param>
        /// <param name="residual">Lift less weight, thrust, pitching moment, over weight and weight times wing length.</param>
        /// <returns>The best state found.</returns>
        public TrimState Solve(in FlightCondition condition, TrimState start, out double[] residual)
        {
            TrimState best = null, now = start.Copy(), previous = null;
            residual = null;
            double[] nearest = null;
            double bestNorm = double.PositiveInfinity, nearestNorm = bestNorm, lastAway = bestNorm, pull = 1;
            bool bobs = !HoldsStill && Array.Exists(start.bob, value => value != 0);
            int halvings = 0;
            for (int iteration = 0; iteration < k_Iterations; iteration++)
            {
                m_System.Linearise(now, condition, bobs);
                double[] r = m_System.Left;
                double norm = Norm(r), change = bobs || HoldsStill ? m_System.Change : double.PositiveInfinity;
                if (norm >= Closed && norm < nearestNorm)
                {
                    nearest = r;
                    nearestNorm = norm;
                }

                if (norm < bestNorm && change < 0.05)
                {
                    best = now.Copy();
                    residual = r;
                    bestNorm = norm;
                }

                if (norm < 0.3 * Closed && change < 0.02)
                    break;
                if (!bobs && !HoldsStill && (norm < k_Near || iteration >= k_Still))
                {
                    bobs = true;
                    lastAway = double.PositiveInfinity;
                    continue;
                }

                double away = norm + k_BobWeight * m_System.Change;
                if (away > 1.5 * lastAway && halvings < k_Halvings)
                {
                    // Too far: half of the last move, and from now on less towards what is preferred.
                    halvings++;
                    pull *= 0.5;
                    now = TrimState.Middle(previous, now);
                    continue;
                }

                lastAway = away;
                halvings = 0;
                previous = now.Copy();
                double[] move = Move(now, Towards(Preferred(condition), now, pull), m_System.Slope, m_System.Settled);
                for (int k = 0; k < now.z.Length; k++)
                    now.z[k] += move[k];
                if (bobs)
                    m_System.Follow(now, move);
            }

            // What is missing is told of a body that bobs on and on too.
            residual ??= nearest;
            return best ?? now;
        }

        /// <summary>Largest part of a residual.</summary>
        public static double Norm(double[] r) =>
            r == null ? double.PositiveInfinity : Math.Max(Math.Abs(r[0]), Math.Max(Math.Abs(r[1]), Math.Abs(r[2])));

        /// <summary>Names what is missing at a condition that does not close.</summary>
        public string Missing(in FlightCondition condition, double[] r)
        {
            if (r == null)
                return $"{condition}: the trim does not settle.";
            return m_Model.Floats
                ? FormattableString.Invariant($"{condition}: does not close; what is left is lift ")
                    + FormattableString.Invariant(
                        $"{r[0]:0.00}, thrust {r[1]:0.00} of the drag, pitching moment {r[2]:0.000} of the drag times the fin's length.")
                : FormattableString.Invariant($"{condition}: does not close; lift is ")
                    + FormattableString.Invariant(
                        $"{1 + r[0]:0.00} of the weight, thrust {r[1]:0.00}, pitching moment {r[2]:0.000} of weight times wing length.");
        }

        /// <summary>First guess of a solution: level in a fluid that carries the body, else nose up.</summary>
        public TrimState Start()
        {
            var start = new TrimState();
            if (m_Model.Floats)
                start.z[0] = 0;
            return start;
        }

        /// <summary>Squared distance of a state from the preferred ones, in their scales.</summary>
        public double Cost(TrimState state, in FlightCondition condition)
        {
            double[] preferred = Preferred(condition);
            double sum = 0;
            for (int k = 0; k < preferred.Length; k++)
            {
                double off = (state.z[k] - preferred[k]) / s_Scales[k];
                sum += off * off;
            }

            return sum;
        }

        /// <summary>Residual of a state as it stands, bob and all.</summary>
        /// <param name="state">The state.</param>
        /// <param name="condition">Steady flight.</param>
        /// <param name="power">Mean power that the wings give to the air, W.</param>
        public double[] Residual(TrimState state, in FlightCondition condition, out double power) =>
            m_System.Residual(state, condition, out power);

        public void Dispose() => m_System.Dispose();

        // min Σ((z + d − preferred)/scale)² with r + J d = 0, unknowns at their bounds held.
        private double[] Move(TrimState now, double[] preferred, double[,] jacobian, double[] r)
        {
            bool[] held = new bool[TrimState.Unknowns];
            double[] move = new double[TrimState.Unknowns];
            for (int round = 0; round < TrimState.Unknowns - 2; round++)
            {
                Solve(now, jacobian, r, preferred, held, move);
                int worst = -1;
                double most = 1e-9;
                for (int k = 0; k < move.Length; k++)
                {
                    double beyond = Math.Max(now.z[k] + move[k] - TrimState.Most(k), TrimState.Least(k) - now.z[k] - move[k]) / s_Scales[k];
                    if (!held[k] && beyond > most)
                    {
                        most = beyond;
                        worst = k;
                    }
                }

                if (worst < 0)
                    break;
                held[worst] = true;
                move[worst] = math.clamp((float)(now.z[worst] + move[worst]), (float)TrimState.Least(worst), (float)TrimState.Most(worst))
                    - now.z[worst];
            }

            for (int k = 0; k < move.Length; k++)
            {
                double step = Math.Max(-s_Scales[k], Math.Min(s_Scales[k], move[k]));
                move[k] = Math.Max(TrimState.Least(k), Math.Min(TrimState.Most(k), now.z[k] + step)) - now.z[k];
            }

            return move;
        }

        private static void Solve(TrimState now, double[,] jacobian, double[] r, double[] preferred, bool[] held, double[] move)
        {
            // d = d0 + S² Jᵀ λ over the free unknowns, d0 = preferred − z; J d = −r.
            double[,] system = new double[3, 4];
            for (int q = 0; q < 3; q++)
            {
                double sum = -r[q];
                for (int k = 0; k < move.Length; k++)
                    sum -= jacobian[q, k] * (held[k] ? move[k] : preferred[k] - now.z[k]);
                system[q, 3] = sum;
                for (int p = 0; p < 3; p++)
                {
                    for (int k = 0; k < move.Length; k++)
                        system[q, p] += held[k] ? 0 : jacobian[q, k] * s_Scales[k] * s_Scales[k] * jacobian[p, k];
                }

                system[q, q] += 1e-9;
            }

            double[] lambda = Dense.Solve(system);
            for (int k = 0; k < move.Length; k++)
            {
                if (held[k])
                    continue;
                move[k] = preferred[k] - now.z[k];
                for (int q = 0; q < 3; q++)
                    move[k] += s_Scales[k] * s_Scales[k] * jacobian[q, k] * lambda[q];
            }
        }

        // The more often a move went too far, the less it goes towards what is preferred.
        private static double[] Towards(double[] preferred, TrimState now, double pull)
        {
            double[] towards = new double[preferred.Length];
            for (int k = 0; k < towards.Length; k++)
                towards[k] = now.z[k] + pull * (preferred[k] - now.z[k]);
            return towards;
        }

        // Pitch and tilt by speed; own frequency and amplitude, no sweep.
        private double[] Preferred(in FlightCondition condition)
        {
            if (Near != null)
                return Near.z;
            if (m_Model.Floats)
                return new double[] { 0, 1, 1, 0, 0 };
            float v = math.abs(condition.Speed);
            double pitch = v < 0.15f ? 50 : v < 0.5f ? 48 : v < 0.9f ? 42 : v < 1.2f ? 32 : 25;
            double tilt = v < 0.15f ? 30 : v < 0.5f ? 20 : v < 0.9f ? 8 : 0;
            return new[] { pitch * k_Degree, 1, 1, tilt * k_Degree, 0 };
        }
    }
}
