using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>The pixels of thinned veins and how they join; short spurs are gone, and small gaps are bridged.</summary>
    internal sealed class VeinGraph
    {
        /// <summary>Longest spur that is cut off, a share of the wing's length.</summary>
        private const double k_Spur = 0.02;

        private readonly PixelMask m_Thin;
        private readonly List<PlanPoint> m_Places = new List<PlanPoint>();
        private readonly Dictionary<int, int> m_Vertices = new Dictionary<int, int>();
        private readonly List<List<VeinLink>> m_Links = new List<List<VeinLink>>();

        /// <param name="thin">Lines of single pixels; spurs are taken out of it.</param>
        /// <param name="length">Of the wing, pixels of the mask.</param>
        public VeinGraph(PixelMask thin, double length)
        {
            m_Thin = thin;
            CutSpurs(k_Spur * length);
            AddVertices();
            VeinGaps.Bridge(this, length);
        }

        /// <summary>Number of pixels.</summary>
        public int Count => m_Places.Count;

        /// <summary>Centre of a pixel, pixels; z is minus the row.</summary>
        public PlanPoint this[int vertex] => m_Places[vertex];

        /// <summary>The pixels that a pixel is joined to.</summary>
        public IReadOnlyList<VeinLink> LinksOf(int vertex) => m_Links[vertex];

        /// <summary>Returns true where veins end or meet at a pixel.</summary>
        public bool IsNode(int vertex) => LinesAt(vertex) != 2;

        /// <summary>The pixel that lies some steps along a vein, or before them where it ends or meets others.</summary>
        /// <param name="vertex">Where to begin; no node.</param>
        /// <param name="side">0 or 1: either way along the vein.</param>
        /// <param name="steps">How many.</param>
        public int Walk(int vertex, int side, int steps)
        {
            int at = m_Links[vertex][side].to, from = vertex;
            for (int step = 1; step < steps && !IsNode(at); step++)
            {
                int next = m_Links[at][0].to == from ? m_Links[at][1].to : m_Links[at][0].to;
                (from, at) = (at, next);
            }

            return at;
        }

        /// <summary>Number of lines that run from a pixel; bridges are no lines of the picture.</summary>
        public int LinesAt(int vertex)
        {
            int lines = 0;
            foreach (VeinLink link in m_Links[vertex])
                lines += link.IsBridge ? 0 : 1;
            return lines;
        }

        /// <summary>Bridges a gap; dearness is the cost of the way over that of a vein as long, above 1.</summary>
        public void Join(int a, int b, double dearness)
        {
            m_Links[a].Add(new VeinLink(b, Distance(a, b), dearness));
            m_Links[b].Add(new VeinLink(a, Distance(a, b), dearness));
        }

        public double Distance(int a, int b) => Math.Sqrt((m_Places[a] - m_Places[b]).LengthSquared);

        // Walks from every end to the next fork, and takes the way out if it was short.
        private void CutSpurs(double longest)
        {
            for (int k = 0; k < m_Thin.width * m_Thin.height; k++)
            {
                int at = k, from = -1;
                var walked = new List<int>();
                List<int> next = m_Thin[at % m_Thin.width, at / m_Thin.width] ? Neighbours(at) : null;
                if (next == null || next.Count != 1)
                    continue;
                while (next.Count <= 2 && walked.Count <= longest)
                {
                    walked.Add(at);
                    int onward = next.Find(pixel => pixel != from && !walked.Contains(pixel));
                    if (next.Count == 1 && walked.Count > 1 || onward == 0)
                        break;
                    (from, at) = (at, onward);
                    next = Neighbours(at);
                }

                if (next.Count <= 2)
                    continue;
                foreach (int pixel in walked)
                    m_Thin[pixel % m_Thin.width, pixel / m_Thin.width] = false;
            }
        }

        private void AddVertices()
        {
            for (int k = 0; k < m_Thin.width * m_Thin.height; k++)
            {
                if (!m_Thin[k % m_Thin.width, k / m_Thin.width])
                    continue;
                m_Vertices.Add(k, m_Places.Count);
                m_Places.Add(new PlanPoint(k % m_Thin.width + 0.5, -(k / m_Thin.width + 0.5)));
            }

            foreach (int pixel in m_Vertices.Keys)
            {
                m_Links.Add(
                    Neighbours(pixel)
                        .ConvertAll(next => new VeinLink(m_Vertices[next], Distance(m_Vertices[pixel], m_Vertices[next]), 1.0)));
            }
        }

        // A corner neighbour counts only where no side neighbour leads there as well.
        private List<int> Neighbours(int pixel)
        {
            int x = pixel % m_Thin.width, y = pixel / m_Thin.width;
            var found = new List<int>();
            for (int dy = -1; dy <= 1; dy++)
            {
                for (int dx = -1; dx <= 1; dx++)
                {
                    bool isCorner = dx != 0 && dy != 0;
                    if ((dx == 0 && dy == 0) || !m_Thin.Contains(x + dx, y + dy)
                        || (isCorner && (m_Thin.Contains(x + dx, y) || m_Thin.Contains(x, y + dy))))
                    {
                        continue;
                    }
                    found.Add(pixel + dy * m_Thin.width + dx);
                }
            }

            return found;
        }
    }
}
