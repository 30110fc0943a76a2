using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Measures how a wing deforms over a beat: twist, camber, bend, lag and stretch of its mesh. Bakes the cuts once for a
    /// mesh.</summary>
    /// <remarks>Nothing here depends on how the wing was moved: any mesh that deforms over a cycle can be measured, also a filmed
    /// one.</remarks>
    [MovedFrom(true, null, "Alate")]
    public sealed class BeatMeasurement
    {
        /// <summary>
        /// Span of the inner section of the twist, wing lengths. A mesh that begins farther out is cut a little past its beginning.
        /// </summary>
        public const float InnerSpan = 0.1f;

        /// <summary>Span of the section of camber and lag, wing lengths.</summary>
        public const float MiddleSpan = 0.44f;

        /// <summary>Span of the outer section of the twist, wing lengths.</summary>
        public const float OuterSpan = 0.75f;

        /// <summary>The percentile of the stretch that is reported beside the largest.</summary>
        private const float k_StretchShare = 0.99f;

        /// <summary>
        /// Distance past the beginning of such a mesh at which it is cut, wing lengths: a base may be pointed, and has no chord there.
        /// </summary>
        private const float k_BaseMargin = 0.02f;

        private static readonly float2 s_Nothing = new float2(float.PositiveInfinity, float.NegativeInfinity);

        private readonly float3[] m_Rest;
        private readonly WingSection m_Inner, m_Middle, m_Outer;
        private readonly EdgeStretch m_Stretch;
        private readonly int m_Tip;

        /// <summary>Prepares to measure a mesh.</summary>
        /// <param name="rest">[vertex] Rest positions, wing frame, wing lengths.</param>
        /// <param name="triangles">Three vertex indices a triangle.</param>
        /// <exception cref="ArgumentException">There is no triangle, or the wing has no chord where it is cut.</exception>
        public BeatMeasurement(float3[] rest, int[] triangles)
        {
            if (triangles.Length == 0)
                throw new ArgumentException("There is no triangle to measure.", nameof(triangles));
            m_Rest = rest;
            m_Inner = WingSection.Cut(rest, triangles, math.max(InnerSpan, Beginning(rest, triangles) + k_BaseMargin));
            m_Middle = WingSection.Cut(rest, triangles, MiddleSpan);
            m_Outer = WingSection.Cut(rest, triangles, OuterSpan);
            m_Stretch = new EdgeStretch(rest, triangles);
            m_Tip = TipBend.FindTip(rest, triangles);
        }

        /// <summary>Twist in the given shape, beyond that at rest, radians.</summary>
        public float Twist(float3[] positions) =>
            SectionTwist.Angle(m_Inner, m_Outer, positions) - SectionTwist.Angle(m_Inner, m_Outer, m_Rest);

        /// <summary>Camber in the given shape, share of the chord.</summary>
        public float Camber(float3[] positions) =>
            SectionCamber.Of(m_Middle, SectionTwist.LeadingEdge(m_Inner, m_Outer, positions), positions);

        /// <summary>Bend of the tip in a frame, beyond that at rest, radians, up positive.</summary>
        public float Bend(in BeatFrame frame) => TipBend.Angle(frame.AtRoot(frame.Positions[m_Tip])) - TipBend.Angle(m_Rest[m_Tip]);

        /// <summary>Measures one beat.</summary>
        /// <param name="beat">One whole beat in order, three frames or more; the last lies before the first one's phase comes
        /// again.</param>
        /// <exception cref="ArgumentException">There are fewer than three frames.</exception>
        public WingDeformation Measure(IReadOnlyList<BeatFrame> beat)
        {
            if (beat.Count < 3)
                throw new ArgumentException($"A beat has three frames or more, not {beat.Count}.", nameof(beat));
            float2 twist = s_Nothing, camber = s_Nothing, bend = s_Nothing;
            float[] stretches = new float[beat.Count * m_Stretch.Count];
            for (int k = 0; k < beat.Count; k++)
            {
                float3[] positions = beat[k].Positions;
                Extend(ref twist, Twist(positions));
                Extend(ref camber, Camber(positions));
                Extend(ref bend, Bend(beat[k]));
                m_Stretch.Measure(positions, new Span<float>(stretches, k * m_Stretch.Count, m_Stretch.Count));
            }

            return new WingDeformation(
                twist.y - twist.x,
                camber.x,
                camber.y,
                bend.y - bend.x,
                math.max(math.abs(bend.x), math.abs(bend.y)),
                EdgeLag.Of(m_Middle, m_Rest, beat),
                TipLag.Of(m_Tip, m_Rest, beat),
                EdgeStretch.Percentile(stretches, 1f),
                EdgeStretch.Percentile(stretches, k_StretchShare));
        }

        /// <summary>
        /// Swing of the camber beyond that of another beat of the same wing, highest minus lowest difference at equal phase, share of the
        /// chord. Beyond the beat of a wing whose joints do not bend, it is the camber that the loads make; the delayed drive cambers a
        /// wing by itself, however stiff it is.
        /// </summary>
        /// <param name="beat">One whole beat in order.</param>
        /// <param name="other">The other one, with as many frames at the same phases.</param>
        /// <exception cref="ArgumentException">The beats do not have as many frames.</exception>
        public float CamberBeyond(IReadOnlyList<BeatFrame> beat, IReadOnlyList<BeatFrame> other)
        {
            if (beat.Count != other.Count)
                throw new ArgumentException($"The other beat has {other.Count} frames, not {beat.Count}.", nameof(other));
            float2 camber = s_Nothing;
            for (int k = 0; k < beat.Count; k++)
                Extend(ref camber, Camber(beat[k].Positions) - Camber(other[k].Positions));
            return camber.y - camber.x;
        }

        private static float Beginning(float3[] rest, int[] triangles)
        {
            float least = float.PositiveInfinity;
            foreach (int vertex in triangles)
                least = math.min(least, rest[vertex].x);
            return least;
        }

        private static void Extend(ref float2 range, float value) => range = new float2(math.min(range.x, value), math.max(range.y, value));
    }
}
