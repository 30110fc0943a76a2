using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>Traces the line of a <see cref="FanField"/> on which it has one value, from the base to the margin.</summary>
    internal sealed class LevelLine
    {
        /// <summary>
        /// Length around the line's known ends, in grid cells, over which it is drawn straight, because the grid does not resolve them.
        /// </summary>
        private const double k_StraightCells = 2.0;

        private readonly FanField m_Field;
        private readonly double m_Value;
        private readonly Dictionary<int, (int First, int Second)> m_Links = new Dictionary<int, (int, int)>();

        private LevelLine(FanField field, double value)
        {
            m_Field = field;
            m_Value = value;
            for (int row = 0; row + 1 < FanField.Rows; row++)
            {
                for (int column = 0; column + 1 < FanField.Columns; column++)
                {
                    int node = row * FanField.Columns + column;
                    Cross(node, node + 1, node + FanField.Columns + 1);
                    Cross(node, node + FanField.Columns + 1, node + FanField.Columns);
                }
            }
        }

        /// <summary>Traces the line.</summary>
        /// <param name="field">The field.</param>
        /// <param name="value">Between 0 and 1.</param>
        /// <param name="root">Where it begins.</param>
        /// <param name="tip">Where it ends.</param>
        public static List<PlanPoint> Trace(FanField field, double value, PlanPoint root, PlanPoint tip)
        {
            var line = new LevelLine(field, value);
            List<PlanPoint> best = null;
            double least = double.MaxValue;
            foreach (List<PlanPoint> piece in line.Pieces())
            {
                List<PlanPoint> cut = Cut(piece, root, tip, k_StraightCells * field.CellSize, out double off);
                if (off >= least)
                    continue;
                least = off;
                best = cut;
            }

            return best ?? new List<PlanPoint> { root, tip };
        }

        // From its point closest to the root to that closest to the tip, without those too close to either.
        private static List<PlanPoint> Cut(List<PlanPoint> piece, PlanPoint root, PlanPoint tip, double straight, out double off)
        {
            int first = Closest(piece, root), last = Closest(piece, tip), step = first <= last ? 1 : -1;
            off = (piece[first] - root).LengthSquared + (piece[last] - tip).LengthSquared;
            var cut = new List<PlanPoint> { root };
            for (int k = first; k != last; k += step)
            {
                bool nearEnd = (piece[k] - root).LengthSquared < straight * straight
                    || (piece[k] - tip).LengthSquared < straight * straight;
                if (!nearEnd)
                    cut.Add(piece[k]);
            }

            cut.Add(tip);
            return cut;
        }

        private static int Closest(List<PlanPoint> piece, PlanPoint p)
        {
            int found = 0;
            for (int k = 1; k < piece.Count; k++)
            {
                if ((piece[k] - p).LengthSquared < (piece[found] - p).LengthSquared)
                    found = k;
            }

            return found;
        }

        private void Cross(int a, int b, int c)
        {
            double va = m_Field.Values[a], vb = m_Field.Values[b], vc = m_Field.Values[c];
            if (double.IsNaN(va) || double.IsNaN(vb) || double.IsNaN(vc))
                return;
            bool ab = IsAbove(va) != IsAbove(vb), bc = IsAbove(vb) != IsAbove(vc), ca = IsAbove(vc) != IsAbove(va);
            if (!ab && !bc)
                return;
            int first = ab ? Edge(a, b) : Edge(b, c), second = ca ? Edge(c, a) : Edge(b, c);
            Link(first, second);
            Link(second, first);
        }

        private bool IsAbove(double value) => value >= m_Value;

        // An edge by its lower node and its direction: along, up or diagonal.
        private static int Edge(int a, int b)
        {
            int low = Math.Min(a, b), step = Math.Max(a, b) - low;
            return 3 * low + (step == 1 ? 0 : step == FanField.Columns ? 1 : 2);
        }

        private void Link(int edge, int other) =>
            m_Links[edge] = m_Links.TryGetValue(edge, out (int First, int Second) known) ? (known.First, other) : (other, -1);

        private IEnumerable<List<PlanPoint>> Pieces()
        {
            var seen = new HashSet<int>();
            foreach (KeyValuePair<int, (int First, int Second)> link in m_Links)
            {
                if (link.Value.Second < 0 && !seen.Contains(link.Key))
                    yield return Follow(link.Key, seen);
            }
        }

        private List<PlanPoint> Follow(int start, HashSet<int> seen)
        {
            var points = new List<PlanPoint>();
            int before = -1, edge = start;
            while (edge >= 0 && seen.Add(edge))
            {
                points.Add(Crossing(edge));
                (int First, int Second) link = m_Links[edge];
                int next = link.First == before ? link.Second : link.First;
                before = edge;
                edge = next;
            }

            return points;
        }

        private PlanPoint Crossing(int edge)
        {
            int low = edge / 3, kind = edge % 3, high = low + (kind == 0 ? 1 : kind == 1 ? FanField.Columns : FanField.Columns + 1);
            double share = (m_Value - m_Field.Values[low]) / (m_Field.Values[high] - m_Field.Values[low]);
            double column = low % FanField.Columns, row = low / FanField.Columns;
            return m_Field.At(column + (kind == 1 ? 0.0 : share), row + (kind == 0 ? 0.0 : share));
        }
    }
}
