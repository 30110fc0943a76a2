using System;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Folded beat as a line in a rect: phase to the right, values up. Continues over both ends.</summary>
    internal sealed class GraphCurve
    {
        private readonly Vector3[] m_Points;

        /// <param name="capacity">Most samples of a beat.</param>
        public GraphCurve(int capacity)
        {
            m_Points = new Vector3[capacity + 2];
        }

        /// <summary>Points of the line; the first <see cref="Count"/> are valid.</summary>
        public Vector3[] Points => m_Points;

        /// <summary>Number of points of the line; 0 for none.</summary>
        public int Count { get; private set; }

        /// <summary>Lays the line through a beat.</summary>
        public void Lay(ReadOnlySpan<BeatSample> folded, Func<BeatSample, float> value, in GraphScale scale, Rect area)
        {
            Count = 0;
            if (folded.Length == 0)
                return;
            BeatSample last = folded[folded.Length - 1], first = folded[0];
            Add(area, last.Phase - 1f, scale.Place(value(last)));
            foreach (BeatSample sample in folded)
                Add(area, sample.Phase, scale.Place(value(sample)));
            Add(area, first.Phase + 1f, scale.Place(value(first)));
            Cut(area);
        }

        /// <summary>Converts phase and value to a place in a rect.</summary>
        /// <param name="area">The rect; Y down, as all of the editor.</param>
        /// <param name="phase">0 at the left, 1 at the right.</param>
        /// <param name="height">0 at the bottom, 1 at the top.</param>
        public static Vector3 At(Rect area, float phase, float height) =>
            new Vector3(area.x + phase * area.width, area.yMax - height * area.height, 0f);

        private void Add(Rect area, float phase, float height) => m_Points[Count++] = At(area, phase, height);

        // Ends the line at the left and right side of the rect.
        private void Cut(Rect area)
        {
            m_Points[0] = AtX(m_Points[0], m_Points[1], area.xMin);
            m_Points[Count - 1] = AtX(m_Points[Count - 2], m_Points[Count - 1], area.xMax);
        }

        private static Vector3 AtX(Vector3 a, Vector3 b, float x) =>
            b.x > a.x ? Vector3.Lerp(a, b, (x - a.x) / (b.x - a.x)) : new Vector3(x, a.y, 0f);
    }
}
