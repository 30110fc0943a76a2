using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// The closed rim of a right wing in plan, wing lengths: from the leading corner of the base along the leading edge around the tip, back along the trailing
    /// edge, and home along the base. It is kept as smooth stretches; where two of them meet is a corner, which a mesh keeps.
    /// </summary>
    internal sealed class WingRim
    {
        /// <summary>Number of steps along each edge; they crowd at the tip, where a rounded edge falls steeply.</summary>
        private const int k_EdgeSteps = 1200;

        private readonly List<PlanarPath> m_Stretches = new List<PlanarPath>();

        private WingRim()
        {
        }

        /// <summary>The smooth stretches in order, each beginning where the one before ends.</summary>
        public IReadOnlyList<PlanarPath> Stretches => m_Stretches;

        /// <summary>Length of the whole rim.</summary>
        public double Length
        {
            get
            {
                var length = 0.0;
                foreach (var stretch in m_Stretches)
                {
                    length += stretch.Length;
                }

                return length;
            }
        }

        /// <summary>The rim of an outline, its margin cut in by scallops where there are any.</summary>
        public static WingRim Of(WingOutline outline, RimScallops scallops)
        {
            var margins = Margins(outline);
            var rim = new WingRim();
            rim.m_Stretches.AddRange(scallops == null ? margins : scallops.Cut(PlanarPath.Join(margins)));
            rim.m_Stretches.Add(PlanarPath.Line((0, outline.TrailingAt(0)), (0, outline.LeadingAt(0))));
            return rim;
        }

        /// <summary>Corners of a polygon on the rim in order, spaced as evenly as the corners of the rim allow.</summary>
        /// <param name="spacing">The distance to come near to.</param>
        /// <param name="isCountOdd">Whether the number of corners shall be odd.</param>
        public PlanPoint[] Polygon(double spacing, bool isCountOdd)
        {
            var pieces = new int[m_Stretches.Count];
            var count = 0;
            var longest = 0;
            for (var k = 0; k < pieces.Length; k++)
            {
                pieces[k] = Math.Max(1, (int)Math.Round(m_Stretches[k].Length / spacing));
                count += pieces[k];
                longest = m_Stretches[k].Length / pieces[k] > m_Stretches[longest].Length / pieces[longest] ? k : longest;
            }

            pieces[longest] += count % 2 == 1 == isCountOdd ? 0 : 1;
            var corners = new List<PlanPoint>();
            for (var k = 0; k < pieces.Length; k++)
            {
                for (var piece = 0; piece < pieces[k]; piece++)
                {
                    var (x, z) = m_Stretches[k].At(m_Stretches[k].Length * piece / pieces[k]);
                    corners.Add(new PlanPoint(x, z));
                }
            }

            return corners.ToArray();
        }

        /// <summary>The margin alone: from the leading corner of the base around the tip to the trailing one.</summary>
        public static PlanarPath Margin(WingOutline outline) => PlanarPath.Join(Margins(outline));

        private static PlanarPath[] Margins(WingOutline outline)
        {
            var leading = Edge(outline.LeadingAt, false);
            var trailing = Edge(outline.TrailingAt, true);
            return outline.HasRoundedTip || outline.ChordAt(1) <= 0
                ? new[] { PlanarPath.Join(leading, trailing) }
                : new[] { leading, PlanarPath.Line(leading.At(leading.Length), trailing.At(0)), trailing };
        }

        private static PlanarPath Edge(Func<double, double> edge, bool isInward)
        {
            var path = new PlanarPath();
            for (var step = 0; step <= k_EdgeSteps; step++)
            {
                var left = isInward ? (double)step / k_EdgeSteps : 1 - (double)step / k_EdgeSteps;
                var span = 1 - left * left;
                path.Add(span, edge(span));
            }

            return path;
        }
    }
}
