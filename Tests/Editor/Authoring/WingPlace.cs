using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Place of a drawn wing in a square picture.</summary>
    internal sealed class WingPlace
    {
        private readonly float m_Cosine;
        private readonly float m_Sine;
        private readonly float m_Mirror;
        private readonly Vector2 m_Middle;

        public WingPlace(Vector2[] outline, int side, float degrees, bool mirrored, float share)
        {
            Side = side;
            m_Cosine = Mathf.Cos(degrees * Mathf.Deg2Rad);
            m_Sine = Mathf.Sin(degrees * Mathf.Deg2Rad);
            m_Mirror = mirrored ? -1f : 1f;
            Vector2[] turned = Array.ConvertAll(outline, Turned);
            float left = turned.Min(p => p.x), right = turned.Max(p => p.x), low = turned.Min(p => p.y), high = turned.Max(p => p.y);
            m_Middle = new Vector2(0.5f * (left + right), 0.5f * (low + high));
            Length = share * side / Math.Max(right - left, high - low);
            Outline = Array.ConvertAll(outline, At);
        }

        /// <summary>Of the picture, pixels.</summary>
        public int Side { get; }

        /// <summary>A wing length, pixels.</summary>
        public float Length { get; }

        /// <summary>The outline, pixels.</summary>
        public Vector2[] Outline { get; }

        /// <summary>A place of the wing in the picture.</summary>
        public Vector2 At(Vector2 point)
        {
            Vector2 turned = Length * (Turned(point) - m_Middle);
            return new Vector2(0.5f * Side + turned.x, 0.5f * Side - turned.y);
        }

        /// <summary>Places of the wing in the picture.</summary>
        public Vector2[] At(IReadOnlyList<Vector2> points)
        {
            var places = new Vector2[points.Count];
            for (int k = 0; k < places.Length; k++)
                places[k] = At(points[k]);
            return places;
        }

        private Vector2 Turned(Vector2 point) =>
            new Vector2(m_Mirror * (m_Cosine * point.x - m_Sine * point.y), m_Sine * point.x + m_Cosine * point.y);
    }
}
