using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// A harmonic function on the wing between its first and last chain: 0 on the first, 1 on the last, rising evenly along the base and
    /// along the margin. Its level lines never meet, never leave the wing, run straight where the wing is plain and bend around its
    /// notches: so the other chains follow them.
    /// </summary>
    internal sealed class FanField
    {
        /// <summary>Grid cells along the field's longer axis and across it.</summary>
        private const int k_Along = 160;
        private const int k_Across = 96;

        /// <summary>Nodes beyond the domain that take the nearest boundary's value, so that level lines reach it.</summary>
        private const int k_Rings = 2;

        private const double k_Start = 0.5;
        private const int k_MostSweeps = 2000;
        private const double k_Converged = 1e-6;

        private readonly PlanPoint m_Origin;
        private readonly PlanPoint m_Along;
        private readonly PlanPoint m_Across;
        private readonly double m_StepAlong;
        private readonly double m_StepAcross;
        private readonly bool[] m_Inside = new bool[Columns * Rows];

        /// <summary>First and last nodes of the rows' parts that lie inside.</summary>
        private readonly List<(int First, int Last)> m_Runs = new List<(int First, int Last)>();

        /// <param name="rim">Corners of the domain, in order around it.</param>
        /// <param name="rimValues">The function's values there; between two corners they run straight.</param>
        /// <param name="axis">The direction in which the domain is long.</param>
        public FanField(IReadOnlyList<PlanPoint> rim, IReadOnlyList<double> rimValues, PlanPoint axis)
        {
            m_Along = PlanPoint.Unit(axis);
            m_Across = new PlanPoint(-m_Along.z, m_Along.x);
            var bounds = new PlanBounds(Turned(rim, default));
            m_StepAlong = (bounds.right - bounds.left) / k_Along;
            m_StepAcross = (bounds.high - bounds.low) / k_Across;
            double left = bounds.left - (k_Rings + 0.5) * m_StepAlong, low = bounds.low - (k_Rings + 0.5) * m_StepAcross;
            m_Origin = m_Along * left + m_Across * low;
            Values = new double[Columns * Rows];
            Array.Fill(Values, double.NaN);

            PlanPoint[] corners = rim.ToArray();
            FindInside(corners);
            SetRim(corners, rimValues.ToArray());
            Solve();
        }

        public static int Columns => k_Along + 2 * k_Rings + 2;

        public static int Rows => k_Across + 2 * k_Rings + 2;

        /// <summary>[row · Columns + column] NaN beyond the rings around the domain.</summary>
        public double[] Values { get; }

        /// <summary>Point of the plane at a fractional node.</summary>
        public PlanPoint At(double column, double row) => m_Origin + m_Along * (column * m_StepAlong) + m_Across * (row * m_StepAcross);

        /// <summary>The larger side of a grid cell.</summary>
        public double CellSize => Math.Max(m_StepAlong, m_StepAcross);

        private void FindInside(PlanPoint[] rim)
        {
            var grid = new PolygonGrid(Turned(rim, m_Origin));
            var crossings = new List<double>();
            for (int row = 0; row < Rows; row++)
            {
                grid.FindCrossings(row * m_StepAcross, crossings);
                for (int k = 0; k + 1 < crossings.Count; k += 2)
                {
                    int last = Math.Min((int)Math.Floor(crossings[k + 1] / m_StepAlong), Columns - 1);
                    int first = Math.Max((int)Math.Ceiling(crossings[k] / m_StepAlong), 0);
                    if (first > last)
                        continue;
                    m_Runs.Add((row * Columns + first, row * Columns + last));
                    for (int column = first; column <= last; column++)
                        m_Inside[row * Columns + column] = true;
                }
            }
        }

        private PlanPoint[] Turned(IReadOnlyList<PlanPoint> points, PlanPoint origin)
        {
            var turned = new PlanPoint[points.Count];
            for (int k = 0; k < turned.Length; k++)
                turned[k] = new PlanPoint(PlanPoint.Dot(points[k] - origin, m_Along), PlanPoint.Dot(points[k] - origin, m_Across));
            return turned;
        }

        private void SetRim(PlanPoint[] rim, double[] rimValues)
        {
            for (int row = 0; row < Rows; row++)
            {
                for (int column = 0; column < Columns; column++)
                {
                    int node = row * Columns + column;
                    if (m_Inside[node])
                        Values[node] = k_Start;
                    else if (HasInside(column, row))
                        Values[node] = Nearest(At(column, row), rim, rimValues);
                }
            }
        }

        // The value at the rim's place closest to a point.
        private static double Nearest(PlanPoint p, PlanPoint[] rim, double[] values)
        {
            double least = double.MaxValue, found = 0.0;
            for (int k = 0; k < rim.Length; k++)
            {
                int next = k + 1 < rim.Length ? k + 1 : 0;
                double share = PlanPoint.ClosestOnSegment(p, rim[k], rim[next]);
                double distance = (rim[k] + (rim[next] - rim[k]) * share - p).LengthSquared;
                if (distance >= least)
                    continue;
                least = distance;
                found = values[k] + (values[next] - values[k]) * share;
            }

            return found;
        }

        private bool HasInside(int column, int row)
        {
            for (int z = Math.Max(row - k_Rings, 0); z <= Math.Min(row + k_Rings, Rows - 1); z++)
            {
                for (int x = Math.Max(column - k_Rings, 0); x <= Math.Min(column + k_Rings, Columns - 1); x++)
                {
                    if (m_Inside[z * Columns + x])
                        return true;
                }
            }

            return false;
        }

        // Successive over-relaxation, every other node at a time as on a chessboard: those of one colour do not wait for each other.
        private void Solve()
        {
            double over = 2.0 / (1.0 + Elementary.Sin(Math.PI / k_Across));
            for (int sweep = 0; sweep < k_MostSweeps; sweep++)
            {
                if (Math.Max(Relax(0, over), Relax(1, over)) < k_Converged)
                    return;
            }
        }

        // The largest change of a node of one colour.
        private double Relax(int colour, double over)
        {
            double ratio = m_StepAlong / m_StepAcross, across = ratio * ratio, share = 1.0 / (2.0 + 2.0 * across);
            double[] values = Values;
            double change = 0.0;
            foreach ((int first, int last) in m_Runs)
            {
                // An even number of columns: rows count on from one colour with the other.
                int start = first + ((first + first / Columns + colour) & 1);
                for (int node = start; node <= last; node += 2)
                {
                    double mean =
                        share * (values[node - 1] + values[node + 1] + across * (values[node - Columns] + values[node + Columns]));
                    double step = over * (mean - values[node]);
                    values[node] += step;
                    change = Math.Max(change, Math.Abs(step));
                }
            }

            return change;
        }
    }
}
