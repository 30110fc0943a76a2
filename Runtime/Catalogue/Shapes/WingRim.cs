using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>The closed rim of a right wing in plan, wing lengths.</summary>
    internal static class WingRim
    {
        /// <summary>Number of steps along each edge; they crowd at the tip, where a rounded edge falls steeply.</summary>
        private const int k_EdgeSteps = 1200;

        /// <summary>
        /// The rim counterclockwise: from the trailing corner of the base around the tip to the leading one, then home along the base.
        /// </summary>
        /// <param name="outline">Outline of the wing.</param>
        /// <param name="scallops">Hollows of its margin; null for none.</param>
        /// <param name="corners">Indices of the points between two smooth stretches, rising; a mesh keeps them.</param>
        public static PlanPoint[] Of(WingOutline outline, RimScallops scallops, out List<int> corners)
        {
            Polyline[] margins = Margins(outline);
            var rim = new List<PlanPoint>();
            corners = new List<int>();
            foreach (Polyline stretch in scallops == null ? margins : scallops.Cut(Polyline.Join(margins)).ToArray())
            {
                corners.Add(rim.Count);
                rim.AddRange(stretch.Points.Take(stretch.Points.Count - 1));
            }

            corners.Add(rim.Count);
            rim.Add(new PlanPoint(0.0, outline.TrailingAt(0.0)));
            rim.Reverse();
            corners.Reverse();
            corners = corners.ConvertAll(corner => rim.Count - 1 - corner);
            return rim.ToArray();
        }

        /// <summary>The margin alone: from the leading corner of the base around the tip to the trailing one.</summary>
        public static Polyline Margin(WingOutline outline) => Polyline.Join(Margins(outline));

        private static Polyline[] Margins(WingOutline outline)
        {
            var leading = Polyline.Trace(k_EdgeSteps, left => OnEdge(outline.LeadingAt, 1.0 - left));
            var trailing = Polyline.Trace(k_EdgeSteps, left => OnEdge(outline.TrailingAt, left));
            return outline.HasRoundedTip || outline.ChordAt(1.0) <= 0.0
                ? new[] { Polyline.Join(leading, trailing) }
                : new[] { leading, new Polyline(new[] { leading.At(leading.Length), trailing.At(0.0) }), trailing };
        }

        private static PlanPoint OnEdge(Func<double, double> edge, double left)
        {
            double span = 1.0 - left * left;
            return new PlanPoint(span, edge(span));
        }
    }
}
