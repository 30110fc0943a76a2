using System;
using System.Numerics;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Finds the beat and attitude that carry an insect steadily: of all that balance lift, thrust and pitching moment the nearest to
    /// preferred ones, within bounds; with the bob of the body that the forces of the beat make.
    /// </summary>
    internal sealed class TrimSolver : IDisposable
    {
        /// <summary>Beats until held wings are settled, and beats that are averaged.</summary>
        private const int k_SettledBeats = 5, k_MeanBeats = 1;

        /// <summary>Residual that counts as closed.</summary>
        public const double Closed = 0.005;

        private const int k_Iterations = 24;

        /// <summary>Residual from which on the body bobs, and iterations after which it does anyway.</summary>
        private const double k_Near = 0.03;
        private const int k_Still = 8;
        private const double k_Degree = Math.PI / 180;

        private static readonly double[] s_Scales = { 15 * k_Degree, 0.08, 0.10, 15 * k_Degree, 10 * k_Degree };
        private static readonly double[] s_Steps = { 3 * k_Degree, 0.02, 0.03, 3 * k_Degree, 2 * k_Degree };

        private readonly FlightModel m_Model;
        private readonly FlightTunnel m_Tunnel;

        public TrimSolver(FlightModel model)
        {
            m_Model = model;
            m_Tunnel = new FlightTunnel(model, TrimState.Unknowns + 1);
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
            TrimState best = null, now = start.Copy();
            residual = null;
            double bestNorm = double.PositiveInfinity, lastNorm = double.PositiveInfinity, share = 1;
            bool bobs = Array.Exists(start.bob, value => value != 0);
            TrimState previous = null;
            double[] move = null, nearest = null;
            for (int iteration = 0; iteration < k_Iterations; iteration++)
            {
                double[,] jacobian = Linearise(now, condition, out double[] r, out BeatLoads loads);
                double norm = Norm(r);
                bobs |= norm < k_Near || iteration >= k_Still;
                double change = HoldsStill ? 0 : bobs ? Bob(now, loads) : double.PositiveInfinity;
                if (norm >= Closed && (nearest == null || norm < Norm(nearest)))
                    nearest = r;
                if (norm < bestNorm && change < 0.05)
                {
                    bestNorm = norm;
                    best = now.Copy();
                    residual = r;
                }

                if (norm < 0.3 * Closed && change < 0.02)
                    break;
                if (norm > 1.5 * lastNorm && previous != null && share > 0.2)
                {
                    // Too far: half of the last move, from where it began.
                    share *= 0.5;
                    for (int k = 0; k < now.z.Length; k++)
                        now.z[k] = previous.z[k] + share * move[k];
                    continue;
                }

                lastNorm = norm;
                share = 1;
                previous = now.Copy();
                move = Move(now, condition, jacobian, r);
                for (int k = 0; k < now.z.Length; k++)
                    now.z[k] += move[k];
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
        public double[] Residual(TrimState state, in FlightCondition condition, out double power)
        {
            BeatLoads[] loads = Fly(new[] { state }, condition);
            power = loads[0].power;
            return Residual(loads[0], condition);
        }

        public void Dispose() => m_Tunnel.Dispose();

        private double[,] Linearise(TrimState at, in FlightCondition condition, out double[] r, out BeatLoads loads)
        {
            var states = new TrimState[TrimState.Unknowns + 1];
            states[0] = at;
            for (int k = 0; k < TrimState.Unknowns; k++)
            {
                states[k + 1] = at.Copy();
                bool down = at.z[k] + s_Steps[k] > TrimState.Most(k);
                states[k + 1].z[k] += down ? -s_Steps[k] : s_Steps[k];
            }

            BeatLoads[] all = Fly(states, condition);
            loads = all[0];
            r = Residual(loads, condition);
            double[,] jacobian = new double[3, TrimState.Unknowns];
            for (int k = 0; k < TrimState.Unknowns; k++)
            {
                double[] moved = Residual(all[k + 1], condition);
                for (int q = 0; q < 3; q++)
                    jacobian[q, k] = (moved[q] - r[q]) / (states[k + 1].z[k] - at.z[k]);
            }

            return jacobian;
        }

        private double[] Residual(BeatLoads loads, in FlightCondition condition)
        {
            double unit = m_Model.TrimForce(condition), carried = m_Model.Weight * m_Model.GravityShare;
            return new[] { (loads.mean[0] - carried) / unit, loads.mean[1] / unit, -loads.mean[2] / (unit * m_Model.Length) };
        }

        private BeatLoads[] Fly(TrimState[] states, in FlightCondition condition)
        {
            for (int k = 0; k <= TrimState.Unknowns; k++)
                m_Tunnel.Set(k, states[Math.Min(k, states.Length - 1)], condition);
            m_Tunnel.Restart();

            // Insects of different frequencies share the steps: each is averaged over its own beats.
            double frequency = m_Model.Frequency * states[0].z[1];
            int substeps = FlightTunnel.Substeps(m_Model, frequency);
            float h = (float)(1 / (frequency * substeps));
            var loads = new BeatLoads[states.Length];
            for (int k = 0; k < states.Length; k++)
                loads[k] = new BeatLoads();
            int steps = (int)Math.Ceiling((k_SettledBeats + k_MeanBeats) * substeps / 0.98) + 1;
            for (int step = 0; step < steps; step++)
            {
                m_Tunnel.World.StepOnce(h);
                for (int k = 0; k < states.Length; k++)
                {
                    double turn = 2 * Math.PI * states[k].z[1] * m_Model.Frequency * h;
                    double end = (step + 1) * turn / (2 * Math.PI), begin = end - turn / (2 * Math.PI);
                    double inside = Math.Min(end, k_SettledBeats + k_MeanBeats) - Math.Max(begin, k_SettledBeats);
                    if (inside > 1e-9)
                        loads[k].Add(m_Tunnel.World.Body(m_Tunnel.Body(k)), (step + 0.5) * turn, inside / k_MeanBeats);
                }
            }

            return loads;
        }

        // Motion of the body under the harmonics of the beat's forces, by their mean damping: (ikω M + K) x' = F + K x. Returns the largest
        // change over a typical size.
        private double Bob(TrimState state, BeatLoads loads)
        {
            double omega = 2 * Math.PI * m_Model.Frequency * state.z[1], change = 0;
            double[] masses = { m_Model.Mass, m_Model.Mass, m_Model.Inertia.c0.x };
            double[] typical = { 0.3, 0.3, 15 };
            for (int k = 0; k < TrimPoint.Harmonics; k++)
            {
                var system = new Complex[3, 4];
                var old = new Complex[3];
                for (int q = 0; q < 3; q++)
                {
                    int at = 2 * ((q == 2 ? 3 : q) * TrimPoint.Harmonics + k);
                    old[q] = new Complex(state.bob[at], -state.bob[at + 1]);
                }

                for (int q = 0; q < 3; q++)
                {
                    system[q, 3] = loads.harmonics[k, q];
                    for (int p = 0; p < 3; p++)
                    {
                        system[q, p] = loads.damping[q, p];
                        system[q, 3] += loads.damping[q, p] * old[p];
                    }

                    system[q, q] += new Complex(0, (k + 1) * omega * masses[q]);
                }

                Complex[] solved = Dense.Solve(system);
                for (int q = 0; q < 3; q++)
                {
                    int at = 2 * ((q == 2 ? 3 : q) * TrimPoint.Harmonics + k);
                    change = Math.Max(change, (solved[q] - old[q]).Magnitude / typical[q]);
                    state.bob[at] = solved[q].Real;
                    state.bob[at + 1] = -solved[q].Imaginary;
                }

                Complex turn = solved[2] / new Complex(0, (k + 1) * omega);
                int turned = 2 * (2 * TrimPoint.Harmonics + k);
                state.bob[turned] = turn.Real;
                state.bob[turned + 1] = -turn.Imaginary;
            }

            return change;
        }

        // min Σ((z + d − preferred)/scale)² with r + J d = 0, unknowns at their bounds held.
        private double[] Move(TrimState now, in FlightCondition condition, double[,] jacobian, double[] r)
        {
            double[] preferred = Preferred(condition);
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
