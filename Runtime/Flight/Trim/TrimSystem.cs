using System;
using System.Numerics;

namespace Alate.Flight
{
    /// <summary>
    /// Equations of a trim about one state: lift, thrust and pitching moment over the unknowns of the beat, with the bob of the body either
    /// held or moved along as the forces of the beat move it.
    /// </summary>
    internal sealed class TrimSystem : IDisposable
    {
        /// <summary>Beats until held wings are settled, and beats that are averaged.</summary>
        private const int k_SettledBeats = 5, k_MeanBeats = 1;

        /// <summary>Velocities of the bob: up, ahead, and of turning.</summary>
        private const int k_Motions = 3;

        /// <summary>
        /// Harmonics of the bob whose forces are measured over their motion; of the higher ones the mean damping is taken.
        /// </summary>
        private const int k_Measured = 2;
        private const int k_Bobs = 2 * k_Motions * k_Measured;

        private const double k_Degree = Math.PI / 180;

        private static readonly double[] s_Steps = { 3 * k_Degree, 0.02, 0.03, 3 * k_Degree, 2 * k_Degree };

        /// <summary>[motion] Typical size, m/s and rad/s, and the share of it by which the bob is moved.</summary>
        private static readonly double[] s_Typical = { 0.3, 0.3, 15 };
        private const double k_Share = 0.05;

        private readonly FlightModel m_Model;
        private readonly FlightTunnel m_Tunnel;
        private FlightTunnel m_BobTunnel;
        private Complex[,] m_Move;
        private double[,] m_Follow;

        public TrimSystem(FlightModel model)
        {
            m_Model = model;
            m_Tunnel = new FlightTunnel(model, TrimState.Unknowns + 1);
        }

        /// <summary>Lift less weight, thrust, pitching moment, over weight and weight times wing length.</summary>
        public double[] Left { get; private set; }

        /// <summary>The same where the bob first settles, if it moves along.</summary>
        public double[] Settled { get; private set; }

        /// <summary>[of the residual][unknown] Derivative, of a bob that moves along or of one that is held.</summary>
        public double[,] Slope { get; private set; }

        /// <summary>Largest part of the way to where the bob settles, over its typical size; 0 for one that is held.</summary>
        public double Change { get; private set; }

        /// <summary>Linearises about a state.</summary>
        /// <param name="at">The state.</param>
        /// <param name="condition">Steady flight.</param>
        /// <param name="bobs">True where the bob moves along.</param>
        public void Linearise(TrimState at, in FlightCondition condition, bool bobs)
        {
            var states = new TrimState[TrimState.Unknowns + (bobs ? k_Bobs : 0) + 1];
            double[] steps = new double[states.Length - 1];
            states[0] = at;
            for (int k = 0; k < steps.Length; k++)
            {
                states[k + 1] = at.Copy();
                steps[k] = k < TrimState.Unknowns ? Step(at, k) : k_Share * s_Typical[MotionOf(k - TrimState.Unknowns)];
                if (k < TrimState.Unknowns)
                    states[k + 1].z[k] += steps[k];
                else
                    MoveBob(states[k + 1], k - TrimState.Unknowns, steps[k]);
            }

            BeatLoads[] loads = Fly(bobs ? m_BobTunnel ??= new FlightTunnel(m_Model, states.Length) : m_Tunnel, states, condition);
            double[][] all = new double[states.Length][];
            for (int k = 0; k < all.Length; k++)
                all[k] = Equations(states[k], loads[k], condition, bobs);
            Left = new[] { all[0][0], all[0][1], all[0][2] };
            Settled = Left;
            Slope = new double[3, TrimState.Unknowns];
            for (int k = 0; k < TrimState.Unknowns; k++)
            {
                for (int q = 0; q < 3; q++)
                    Slope[q, k] = (all[k + 1][q] - all[0][q]) / steps[k];
            }

            Change = 0;
            if (bobs)
                Eliminate(at, loads[0], all, steps);
        }

        /// <summary>Moves the bob of the state that was linearised to where it settles while the unknowns move.</summary>
        /// <param name="state">Copy of the state.</param>
        /// <param name="move">[unknown] Move.</param>
        public void Follow(TrimState state, double[] move)
        {
            for (int k = 0; k < k_Bobs; k++)
            {
                double sum = m_Follow[k, 0];
                for (int j = 0; j < move.Length; j++)
                    sum += m_Follow[k, j + 1] * move[j];
                double most = s_Typical[MotionOf(k)];
                MoveBob(state, k, -Math.Max(-most, Math.Min(most, sum)));
            }

            for (int k = k_Measured; k < TrimPoint.Harmonics; k++)
            {
                for (int q = 0; q < k_Motions; q++)
                    SetMotion(state, k, q, Motion(state, k, q) + m_Move[k, q]);
            }

            Turn(state);
        }

        /// <summary>Residual of a state as it stands, bob and all.</summary>
        /// <param name="state">The state.</param>
        /// <param name="condition">Steady flight.</param>
        /// <param name="power">Mean power that the wings give to the air, W.</param>
        public double[] Residual(TrimState state, in FlightCondition condition, out double power)
        {
            BeatLoads loads = Fly(m_Tunnel, new[] { state }, condition)[0];
            power = loads.power;
            return Equations(state, loads, condition, false);
        }

        public void Dispose()
        {
            m_Tunnel.Dispose();
            m_BobTunnel?.Dispose();
        }

        // The bob follows the unknowns: G db = −g − G_z dz, and the balance sees both.
        private void Eliminate(TrimState at, BeatLoads loads, double[][] all, double[] steps)
        {
            double[,] own = new double[k_Bobs, k_Bobs], coupling = new double[3, k_Bobs];
            double[,] right = new double[k_Bobs, TrimState.Unknowns + 1];
            for (int j = 0; j < steps.Length; j++)
            {
                bool isBob = j >= TrimState.Unknowns;
                for (int q = 0; q < 3 && isBob; q++)
                    coupling[q, j - TrimState.Unknowns] = (all[j + 1][q] - all[0][q]) / steps[j];
                for (int i = 0; i < k_Bobs; i++)
                {
                    double slope = (all[j + 1][3 + i] - all[0][3 + i]) / steps[j];
                    if (isBob)
                        own[i, j - TrimState.Unknowns] = slope;
                    else
                        right[i, j + 1] = slope;
                }
            }

            for (int i = 0; i < k_Bobs; i++)
                right[i, 0] = all[0][3 + i];
            m_Follow = Dense.SolveMany(own, right);
            double[,] through = Dense.Multiply(coupling, m_Follow);
            Settled = new double[3];
            for (int q = 0; q < 3; q++)
            {
                Settled[q] = Left[q] - through[q, 0];
                for (int k = 0; k < TrimState.Unknowns; k++)
                    Slope[q, k] -= through[q, k + 1];
            }

            for (int k = 0; k < k_Bobs; k++)
                Change = Math.Max(Change, Math.Abs(m_Follow[k, 0]) / s_Typical[MotionOf(k)]);
            m_Move = new Complex[TrimPoint.Harmonics, k_Motions];
            for (int k = k_Measured; k < TrimPoint.Harmonics; k++)
                Damp(at, loads, k);
        }

        // By the mean damping of the beat: (ikω M + K) d = F − ikω M x.
        private void Damp(TrimState at, BeatLoads loads, int k)
        {
            var system = new Complex[k_Motions, k_Motions + 1];
            for (int q = 0; q < k_Motions; q++)
            {
                for (int p = 0; p < k_Motions; p++)
                    system[q, p] = loads.damping[q, p];
                Complex inertia = Inertia(at, k, q);
                system[q, q] += inertia;
                system[q, k_Motions] = loads.harmonics[k, q] - inertia * Motion(at, k, q);
            }

            Complex[] moved = Dense.Solve(system);
            for (int q = 0; q < k_Motions; q++)
            {
                m_Move[k, q] = moved[q];
                Change = Math.Max(Change, moved[q].Magnitude / s_Typical[q]);
            }
        }

        // The balance of the beat, and for each motion of the bob ikω M x − F, as real and imaginary parts.
        private double[] Equations(TrimState state, BeatLoads loads, in FlightCondition condition, bool bobs)
        {
            double unit = m_Model.TrimForce(condition), carried = m_Model.Weight * m_Model.GravityShare;
            double[] left = new double[3 + (bobs ? k_Bobs : 0)];
            left[0] = (loads.mean[0] - carried) / unit;
            left[1] = loads.mean[1] / unit;
            left[2] = -loads.mean[2] / (unit * m_Model.Length);
            for (int i = 0; i < left.Length - 3; i += 2)
            {
                int q = MotionOf(i), k = HarmonicOf(i);
                Complex part = Inertia(state, k, q) * Motion(state, k, q) - loads.harmonics[k, q];
                left[3 + i] = part.Real;
                left[4 + i] = part.Imaginary;
            }

            return left;
        }

        private Complex Inertia(TrimState state, int harmonic, int motion) =>
            new Complex(0, (harmonic + 1) * Omega(state) * (motion == 2 ? m_Model.Inertia.c0.x : m_Model.Mass));

        private double Omega(TrimState state) => 2 * Math.PI * m_Model.Frequency * state.z[1];

        private static double Step(TrimState at, int unknown) =>
            at.z[unknown] + s_Steps[unknown] > TrimState.Most(unknown) ? -s_Steps[unknown] : s_Steps[unknown];

        // [harmonic][motion] real, imaginary.
        private static int MotionOf(int bob) => bob / 2 % k_Motions;

        private static int HarmonicOf(int bob) => bob / 2 / k_Motions;

        private void MoveBob(TrimState state, int bob, double by)
        {
            int q = MotionOf(bob), k = HarmonicOf(bob);
            SetMotion(state, k, q, Motion(state, k, q) + (bob % 2 == 0 ? new Complex(by, 0) : new Complex(0, by)));
            Turn(state);
        }

        private static int At(int harmonic, int motion) => 2 * ((motion == 2 ? 3 : motion) * TrimPoint.Harmonics + harmonic);

        private static Complex Motion(TrimState state, int harmonic, int motion) =>
            new Complex(state.bob[At(harmonic, motion)], -state.bob[At(harmonic, motion) + 1]);

        private static void SetMotion(TrimState state, int harmonic, int motion, Complex value)
        {
            state.bob[At(harmonic, motion)] = value.Real;
            state.bob[At(harmonic, motion) + 1] = -value.Imaginary;
        }

        // The turn is the integral of its rate.
        private void Turn(TrimState state)
        {
            for (int k = 0; k < TrimPoint.Harmonics; k++)
            {
                Complex turn = Motion(state, k, 2) / new Complex(0, (k + 1) * Omega(state));
                int at = 2 * (2 * TrimPoint.Harmonics + k);
                state.bob[at] = turn.Real;
                state.bob[at + 1] = -turn.Imaginary;
            }
        }

        private BeatLoads[] Fly(FlightTunnel tunnel, TrimState[] states, in FlightCondition condition)
        {
            for (int k = 0; k < tunnel.Count; k++)
                tunnel.Set(k, states[Math.Min(k, states.Length - 1)], condition);
            tunnel.Restart();

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
                tunnel.World.StepOnce(h);
                for (int k = 0; k < states.Length; k++)
                {
                    double turn = 2 * Math.PI * states[k].z[1] * m_Model.Frequency * h;
                    double end = (step + 1) * turn / (2 * Math.PI), begin = end - turn / (2 * Math.PI);
                    double inside = Math.Min(end, k_SettledBeats + k_MeanBeats) - Math.Max(begin, k_SettledBeats);
                    if (inside > 1e-9)
                        loads[k].Add(tunnel.World.Body(tunnel.Body(k)), (step + 0.5) * turn, inside / k_MeanBeats);
                }
            }

            return loads;
        }
    }
}
