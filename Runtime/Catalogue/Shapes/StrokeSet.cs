using System;
using System.Collections.Generic;

namespace Alate.Catalogue
{
    /// <summary>Polylines in the plane of the wing, with the distance of a place to the nearest of them.</summary>
    internal sealed class StrokeSet
    {
        private readonly List<Stroke> m_Strokes = new List<Stroke>();
        private StrokeGrid m_Grid;

        /// <summary>Adds a polyline given as x, z, x, z, …; the way along it counts on from <paramref name="start"/>.</summary>
        public StrokeSet Add(IReadOnlyList<double> coordinates, double start = 0)
        {
            for (int i = 0; i + 3 < coordinates.Count; i += 2)
            {
                var stroke = new Stroke(coordinates[i], coordinates[i + 1], coordinates[i + 2], coordinates[i + 3], start);
                m_Strokes.Add(stroke);
                start += stroke.length;
            }

            m_Grid = null;
            return this;
        }

        /// <summary>Soft line along the strokes: 1 within the limit of them, 0 beyond it, over the given width.</summary>
        public float Line(double x, double z, double limit, double softness) =>
            Ink.Within(Distance(x, z, out _, limit + softness), limit, softness);

        /// <summary>
        /// Distance to the nearest stroke, with the distance along its polyline of the nearest point; a huge number without strokes.
        /// </summary>
        /// <param name="x">Along the span.</param>
        /// <param name="z">Forward.</param>
        /// <param name="along">Along the polyline.</param>
        /// <param name="reach">A stroke beyond it need not be found: the distance may then be a huge number too.</param>
        public double Distance(double x, double z, out double along, double reach = double.MaxValue)
        {
            along = 0;
            if (m_Strokes.Count == 0)
                return double.MaxValue;

            m_Grid ??= new StrokeGrid(m_Strokes.ToArray());
            double nearest = double.MaxValue;
            Stroke[] around = m_Grid.Around(x, z, reach);
            for (int k = 0; k < around.Length; k++)
            {
                double distance = around[k].DistanceSquared(x, z, out double here);
                if (distance < nearest)
                {
                    nearest = distance;
                    along = here;
                }
            }

            return Math.Sqrt(nearest);
        }
    }
}
