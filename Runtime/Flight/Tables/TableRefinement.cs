using System;

namespace Alate.Flight
{
    /// <summary>
    /// Adds speeds and climbs to a table where the trims of two neighbours are so far apart that the insect does not fly well by what is
    /// mixed of them. Of the trims that close there, the nearest to the middle of the two is taken, so that trims change as little as they
    /// can from point to point.
    /// </summary>
    internal sealed class TableRefinement
    {
        /// <summary>Least distance of two speeds, and of two climbs, m/s.</summary>
        private const float k_LeastSpeed = 0.03f, k_LeastClimb = 0.07f;

        private readonly float m_Frequency;
        private readonly Func<FlightCondition, TrimState, TrimState> m_Solve;
        private readonly Func<TrimTable, FlightCondition, bool> m_Mixes;
        private readonly Action<TrimTable, int, int, TrimState> m_Add;

        /// <param name="frequency">Of the insect's beat, Hz.</param>
        /// <param name="solve">Finds the trim of a condition that is nearest to a state; null where none closes.</param>
        /// <param name="mixes">Returns true where the insect flies well by what a table mixes at a condition.</param>
        /// <param name="add">Finds the gains of a trim and sets the table's point where they hold the insect.</param>
        public TableRefinement(float frequency, Func<FlightCondition, TrimState, TrimState> solve,
            Func<TrimTable, FlightCondition, bool> mixes, Action<TrimTable, int, int, TrimState> add)
        {
            m_Frequency = frequency;
            m_Solve = solve;
            m_Mixes = mixes;
            m_Add = add;
        }

        /// <summary>Flies between all speeds and climbs of a table and adds what is missing.</summary>
        /// <returns>The table, or a new one in its place; the old one is disposed then.</returns>
        public TrimTable Refine(TrimTable table)
        {
            try
            {
                for (int s = 0; s + 1 < table.Speeds.Length; s++)
                {
                    // Halfway to an added speed too.
                    while (TryAddSpeed(ref table, s)) { }
                }

                for (int c = 0; c + 1 < table.ClimbRates.Length; c++)
                    TryAddClimb(ref table, c);
                for (int s = 0; s < table.Speeds.Length; s++)
                    ExtendClimbs(table, s);
                table.Fill();
                return table;
            }
            catch
            {
                // It may be a new one by now, which nobody else knows.
                table.Dispose();
                throw;
            }
        }

        // Climbs that did not close, or did not mix, are tried again between those beside them that do.
        private void ExtendClimbs(TrimTable table, int s)
        {
            int level = table.LevelClimb;
            foreach (int way in new[] { -1, 1 })
            {
                for (int c = level + way; c >= 0 && c < table.ClimbRates.Length && table.IsClosed(s, c - way); c += way)
                {
                    int beside = s + 1 < table.Speeds.Length && table.IsClosed(s + 1, c) ? s + 1 : s - 1;
                    if (table.IsClosed(s, c) || beside < 0 || !table.IsClosed(beside, c))
                        continue;
                    AddPoint(table, s, c, TrimState.Middle(State(table, s, c - way), State(table, beside, c)));
                    if (!table.IsClosed(s, c))
                        break;
                    table.Fill();
                    bool mixes = m_Mixes(
                        table, new FlightCondition(table.Speeds[s], 0.5f * (table.ClimbRates[c] + table.ClimbRates[c - way])))
                        && m_Mixes(table, new FlightCondition(0.5f * (table.Speeds[s] + table.Speeds[beside]), table.ClimbRates[c]));
                    if (!mixes)
                        table.Open(s, c);
                }
            }
        }

        private bool TryAddSpeed(ref TrimTable table, int s)
        {
            int level = table.LevelClimb;
            float middle = 0.5f * (table.Speeds[s] + table.Speeds[s + 1]);
            if (middle - table.Speeds[s] < k_LeastSpeed || !table.IsClosed(s, level) || !table.IsClosed(s + 1, level))
                return false;
            bool mixes = true;
            for (int c = 0; c < table.ClimbRates.Length && mixes; c++)
            {
                mixes = !table.IsClosed(s, c) || !table.IsClosed(s + 1, c)
                    || m_Mixes(table, new FlightCondition(middle, table.ClimbRates[c]));
            }
            if (mixes)
                return false;
            TrimTable refined = table.WithSpeed(middle);
            AddRow(refined, s + 1);
            return Replace(ref table, refined, refined.IsClosed(s + 1, level));
        }

        private void TryAddClimb(ref TrimTable table, int c)
        {
            float middle = 0.5f * (table.ClimbRates[c] + table.ClimbRates[c + 1]);
            if (middle - table.ClimbRates[c] < k_LeastClimb)
                return;
            bool mixes = true;
            for (int s = 0; s < table.Speeds.Length && mixes; s++)
            {
                mixes = !table.IsClosed(s, c) || !table.IsClosed(s, c + 1)
                    || m_Mixes(table, new FlightCondition(table.Speeds[s], middle));
            }
            if (mixes)
                return;
            TrimTable refined = table.WithClimb(middle);
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                TrimState sinking = State(refined, s, c), climbing = State(refined, s, c + 2);
                if (sinking != null && climbing != null)
                    AddPoint(refined, s, c + 1, TrimState.Middle(sinking, climbing));
            }

            Replace(ref table, refined, true);
        }

        private static bool Replace(ref TrimTable table, TrimTable refined, bool isBetter)
        {
            (isBetter ? table : refined).Dispose();
            if (isBetter)
                table = refined;
            table.Fill();
            return isBetter;
        }

        // From the level trim outwards: each the nearest to the middle of the slower and the faster one, or, where one does not close, of
        // the other and the one nearer to level.
        private void AddRow(TrimTable table, int s)
        {
            int level = table.LevelClimb;
            AddPoint(table, s, level, TrimState.Middle(State(table, s - 1, level), State(table, s + 1, level)));
            foreach (int way in new[] { -1, 1 })
            {
                for (int c = level + way; c >= 0 && c < table.ClimbRates.Length && table.IsClosed(s, c - way); c += way)
                {
                    TrimState slower = State(table, s - 1, c), faster = State(table, s + 1, c), inner = State(table, s, c - way);
                    if (slower == null && faster == null)
                        break;
                    bool isBetween = slower != null && faster != null;
                    AddPoint(table, s, c, isBetween ? TrimState.Middle(slower, faster) : TrimState.Middle(inner, slower ?? faster));
                }
            }
        }

        private void AddPoint(TrimTable table, int s, int c, TrimState near)
        {
            var condition = new FlightCondition(table.Speeds[s], table.ClimbRates[c]);
            TrimState trim = m_Solve(condition, near);
            if (trim != null)
                m_Add(table, s, c, trim);
        }

        private TrimState State(TrimTable table, int s, int c) =>
            table.IsClosed(s, c) ? TrimState.Read(table.Point(s, c), m_Frequency) : null;
    }
}
