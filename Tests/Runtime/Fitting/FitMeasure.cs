using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Measures how a skeleton lies in a wing whose true outline is known, seen from above; shares of the span.</summary>
    internal sealed class FitMeasure
    {
        private const int k_PointsPerBone = 40;

        private readonly WingSkeleton m_Skeleton;
        private readonly PlanPoint[] m_Outline;
        private readonly float3 m_Origin;
        private readonly float3 m_Right;
        private readonly float3 m_Ahead;

        public FitMeasure(WingSkeleton skeleton, Vector3[] outline)
        {
            m_Skeleton = skeleton;
            m_Origin = skeleton.GetJoint(0, 0);
            m_Right = math.normalize(skeleton.SpanAxis);
            m_Ahead = math.normalize(math.cross(skeleton.SpanAxis, skeleton.UpAxis));
            m_Outline = Array.ConvertAll(outline, Seen);
            foreach (PlanPoint p in m_Outline)
                Span = Math.Max(Span, p.x);
        }

        /// <summary>From the principal chain's root to the farthest place along the span axis, mesh units.</summary>
        public double Span { get; }

        /// <summary>Largest distance of any place of a bone outside the wing from it.</summary>
        public double Outside()
        {
            double outside = 0.0;
            for (int i = 0; i < m_Skeleton.ChainCount; i++)
            {
                foreach (PlanPoint p in Walk(i))
                {
                    if (!Polygon.Contains(m_Outline, p))
                        outside = Math.Max(outside, Distance(p, m_Outline, true));
                }
            }

            return outside / Span;
        }

        /// <summary>
        /// Largest distance of the outer two thirds of the principal chain's length from the leading edge between its root and its tip.
        /// </summary>
        public double OffLeadingEdge()
        {
            List<PlanPoint> chain = Walk(0);
            List<PlanPoint> edge = Edge(Nearest(chain[0]), Nearest(chain[chain.Count - 1]));
            double off = 0.0, walked = 0.0, length = Polyline.LengthOf(chain);
            for (int k = 1; k < chain.Count; k++)
            {
                walked += Math.Sqrt((chain[k] - chain[k - 1]).LengthSquared);
                if (walked >= length / 3.0)
                    off = Math.Max(off, Distance(chain[k], edge, false));
            }

            return off / Span;
        }

        /// <summary>Largest distance of a chain's tip from the outline.</summary>
        public double TipsOffMargin()
        {
            double off = 0.0;
            for (int i = 0; i < m_Skeleton.ChainCount; i++)
                off = Math.Max(off, Distance(Seen(m_Skeleton.GetJoint(i, m_Skeleton.JointsPerChain - 1)), m_Outline, true));
            return off / Span;
        }

        /// <summary>Largest distance between the joints of two skeletons, over the span of the first.</summary>
        public double Apart(WingSkeleton other, Func<Vector3, Vector3> place, double scale, int firstChain = 0)
        {
            double apart = 0.0;
            for (int i = firstChain; i < m_Skeleton.ChainCount; i++)
            {
                for (int j = 0; j < m_Skeleton.JointsPerChain; j++)
                    apart = Math.Max(apart, math.distance((float3)place(m_Skeleton.GetJoint(i, j)), (float3)other.GetJoint(i, j)));
            }

            return apart / (scale * Span);
        }

        private PlanPoint Seen(Vector3 point)
        {
            float3 from = (float3)point - m_Origin;
            return new PlanPoint(math.dot(from, m_Right), math.dot(from, m_Ahead));
        }

        private List<PlanPoint> Walk(int chain)
        {
            var points = new List<PlanPoint>();
            for (int j = 0; j + 1 < m_Skeleton.JointsPerChain; j++)
            {
                PlanPoint from = Seen(m_Skeleton.GetJoint(chain, j)), to = Seen(m_Skeleton.GetJoint(chain, j + 1));
                for (int k = 0; k < k_PointsPerBone; k++)
                    points.Add(from + (to - from) * ((double)k / k_PointsPerBone));
            }

            points.Add(Seen(m_Skeleton.GetJoint(chain, m_Skeleton.JointsPerChain - 1)));
            return points;
        }

        private int Nearest(PlanPoint p)
        {
            int found = 0;
            for (int k = 1; k < m_Outline.Length; k++)
            {
                if ((m_Outline[k] - p).LengthSquared < (m_Outline[found] - p).LengthSquared)
                    found = k;
            }

            return found;
        }

        // Of both ways round from the root to the tip the one that does not pass the last chain's tip.
        private List<PlanPoint> Edge(int from, int to)
        {
            int last = Nearest(Seen(m_Skeleton.GetJoint(m_Skeleton.ChainCount - 1, m_Skeleton.JointsPerChain - 1)));
            int count = m_Outline.Length;
            int step = (last - from + count) % count < (to - from + count) % count ? -1 : 1;
            var edge = new List<PlanPoint>();
            for (int k = from; k != to; k = (k + step + count) % count)
                edge.Add(m_Outline[k]);
            edge.Add(m_Outline[to]);
            return edge;
        }

        private static double Distance(PlanPoint p, IReadOnlyList<PlanPoint> path, bool closed)
        {
            double least = double.MaxValue;
            for (int k = closed ? 0 : 1; k < path.Count; k++)
                least = Math.Min(least, PlanPoint.DistanceSquared(p, path[k == 0 ? path.Count - 1 : k - 1], path[k]));
            return Math.Sqrt(least);
        }
    }
}
