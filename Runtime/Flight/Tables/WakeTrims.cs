using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Trims of a table in the air of their own wakes, in rounds: compute the wake of each trim, look for the trim again in its air, until
    /// both agree. Where an insect hovers in its own wake that is another one in each beat, it takes the air of a trim beside it, as much
    /// faster as an actuator disk makes it.
    /// </summary>
    internal sealed class WakeTrims
    {
        /// <summary>
        /// Most rounds, share of the way to the air of the last wake, and difference between both, over the wake's, that ends them. A
        /// swallowtail with a wake of wide cores takes eight at 0.15 m/s.
        /// </summary>
        private const int k_Rounds = 12;
        private const float k_Step = 0.9f, k_Settled = 0.03f;

        private readonly FlightModel m_Model;
        private readonly ITrimWake m_Wake;
        private readonly TrimSolver m_Solver;

        public WakeTrims(FlightModel model, ITrimWake wake, TrimSolver solver)
        {
            m_Model = model;
            m_Wake = wake;
            m_Solver = solver;
        }

        /// <summary>Trim in the air of its own wake, or in that of one beside it.</summary>
        /// <param name="condition">Of the trim.</param>
        /// <param name="still">Trim in air at rest; null where none closes.</param>
        /// <param name="beside">Trims beside it that have met their wakes, the nearest first.</param>
        /// <param name="log">Receiver of what is borrowed; null for none.</param>
        /// <returns>The trim; null where none closes.</returns>
        public TrimState Meet(
            in FlightCondition condition, TrimState still, List<(FlightCondition Condition, TrimState Trim)> beside, Action<string> log)
        {
            foreach ((FlightCondition near, TrimState trim) in beside)
            {
                TrimState met = Solve(condition, Borrow(condition, near, trim));
                if (met != null)
                    return met;
            }

            TrimState own = still == null ? null : Solve(condition, still);
            if (own != null)
                return own;
            foreach ((FlightCondition near, TrimState trim) in beside)
            {
                TrimState met = Close(condition, Borrow(condition, near, trim));
                if (met == null)
                    continue;
                log?.Invoke($"{condition}: the wake is another one in each beat; the air is that of {near}, scaled.");
                return met;
            }

            return null;
        }

        // In the air of its own wake; null where none closes, or the wake is another one in each beat. A trim is returned as its wake was
        // found: one that is moved once more may leave that air.
        private TrimState Solve(in FlightCondition condition, TrimState start)
        {
            TrimState trim = start;
            var found = new WingInflow[TrimPoint.Pairs];
            for (int round = 0; round < k_Rounds && trim != null && m_Wake.Find(m_Model, trim, condition, found); round++)
            {
                float change = Change(trim, found);
                if (round > 0 && change < k_Settled)
                    return trim;
                Towards(trim = trim.Copy(), found);
                trim = Close(condition, trim);
            }

            return null;
        }

        // The same beat in the same air, as much faster or slower as an actuator disk makes it at this speed.
        private TrimState Borrow(in FlightCondition condition, in FlightCondition near, TrimState lender)
        {
            TrimState trim = lender.Copy();
            float share = DiskShare(Mean(lender), SpeedOf(near), SpeedOf(condition));
            for (int pair = 0; pair < trim.inflow.Length; pair++)
                trim.inflow[pair] *= share;
            return trim;
        }

        private static float SpeedOf(in FlightCondition condition) => math.length(new float2(condition.Speed, condition.Climb));

        /// <summary>Induced speed of a disk at one speed over that at another: w √(V² + w²) is the same for the same force.</summary>
        /// <param name="induced">Speed that it induces at <paramref name="speed"/>, m/s.</param>
        /// <param name="speed">Of its flight, m/s.</param>
        /// <param name="other">The other speed of its flight, m/s.</param>
        internal static float DiskShare(float induced, float speed, float other)
        {
            if (!(induced > 0f))
                return 1f;
            float carried = induced * induced * (speed * speed + induced * induced), half = 0.5f * other * other;
            return math.sqrt(carried / (half + math.sqrt(half * half + carried))) / induced;
        }

        private TrimState Close(in FlightCondition condition, TrimState trim)
        {
            TrimState closed = m_Solver.Solve(condition, trim, out double[] residual);
            return TrimSolver.Norm(residual) < TrimSolver.Closed ? closed : null;
        }

        // How far the air of a trim is from another, over the size of that.
        private static float Change(TrimState trim, WingInflow[] found)
        {
            float change = 0f, size = 0f;
            for (int pair = 0; pair < found.Length; pair++)
            {
                change += (found[pair] + trim.inflow[pair] * -1f).MeanSquare;
                size += found[pair].MeanSquare;
            }

            return size > 0f ? math.sqrt(change / size) : 0f;
        }

        // Moves the air of a trim towards another.
        private static void Towards(TrimState trim, WingInflow[] found)
        {
            bool isFirst = Array.TrueForAll(trim.inflow, air => !air.IsSet);
            for (int pair = 0; pair < found.Length; pair++)
                trim.inflow[pair] = isFirst ? found[pair] : trim.inflow[pair] * (1f - k_Step) + found[pair] * k_Step;
        }

        // Mean speed of the air over the pairs of wings, m/s.
        private float Mean(TrimState trim)
        {
            float sum = 0f;
            int pairs = math.min(m_Model.Wings.Count / 2, trim.inflow.Length);
            for (int pair = 0; pair < pairs; pair++)
                sum += math.length(trim.inflow[pair].mean) * m_Model.Length;
            return pairs > 0 ? sum / pairs : 0f;
        }
    }
}
