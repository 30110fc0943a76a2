using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Lattice of vortex rings on a wing at a moment. Corners P(i, j) are i = 0 … n along the chord from the leading edge, j = 0 … m
    /// along the span; the corners of the rings lie a quarter of a panel behind them, the last row behind the trailing edge.
    /// </summary>
    internal sealed class WingLattice
    {
        /// <summary>Share of a panel that the lattice ends short of a tip or a free root.</summary>
        private const float k_EndGap = 0.25f;

        private readonly IWingMotion m_Motion;
        private readonly float2[] m_Places;
        private readonly float m_TrailingShare;

        public WingLattice(WakeWing wing, WakeSettings settings)
        {
            m_Motion = wing.Motion;
            m_TrailingShare = settings.TrailingShare;
            FreeRoot = wing.FreeRoot;
            ChordPanels = settings.ChordPanels;
            SpanPanels = settings.SpanPanels;
            int corners = (ChordPanels + 1) * (SpanPanels + 1);
            m_Places = new float2[corners];
            Corners = new float3[corners];
            CornerVelocities = new float3[corners];
            Rings = new float3[corners];
            Controls = new float3[RingCount];
            Normals = new float3[RingCount];
            Motions = new float3[RingCount];
            Circulation = new float[RingCount];
            Before = new float[RingCount];
            LongBefore = new float[RingCount];
            for (int i = 0; i <= ChordPanels; i++)
            {
                for (int j = 0; j <= SpanPanels; j++)
                    m_Places[Corner(i, j)] = new float2((float)i / ChordPanels, Station(j));
            }

            MeanChord = FindMeanChord();
        }

        public int ChordPanels { get; }
        public int SpanPanels { get; }
        public int RingCount => ChordPanels * SpanPanels;
        public bool FreeRoot { get; }

        /// <summary>Area over span, reference lengths.</summary>
        public float MeanChord { get; }

        /// <summary>[i · (m + 1) + j] Corners of the panels.</summary>
        public float3[] Corners { get; }

        /// <summary>[i · (m + 1) + j] Velocities of the corners.</summary>
        public float3[] CornerVelocities { get; }

        /// <summary>[i · (m + 1) + j] Corners of the rings.</summary>
        public float3[] Rings { get; }

        /// <summary>[i · m + j] Points at three quarters of the panels, in which no air crosses the wing.</summary>
        public float3[] Controls { get; }

        /// <summary>[i · m + j] Unit normals: a positive circulation makes a force along them.</summary>
        public float3[] Normals { get; }

        /// <summary>[i · m + j] Velocities of the controls.</summary>
        public float3[] Motions { get; }

        /// <summary>[i · m + j] Circulation of the rings, squared reference lengths a beat; a step before, and two.</summary>
        public float[] Circulation { get; }
        public float[] Before { get; }
        public float[] LongBefore { get; }

        public int Corner(int i, int j) => i * (SpanPanels + 1) + j;

        public int Ring(int i, int j) => i * SpanPanels + j;

        /// <summary>Share of the span at which the middle of a strip lies.</summary>
        public float Middle(int j) => 0.5f * (m_Places[Corner(0, j)].y + m_Places[Corner(0, j + 1)].y);

        /// <summary>Share of the span over which a strip's rings reach.</summary>
        public float Width(int j) => m_Places[Corner(0, j + 1)].y - m_Places[Corner(0, j)].y;

        /// <summary>Vector of a panel along its chord.</summary>
        public float3 Chordwise(int i, int j) =>
            0.5f * (Corners[Corner(i + 1, j)] + Corners[Corner(i + 1, j + 1)] - Corners[Corner(i, j)] - Corners[Corner(i, j + 1)]);

        /// <summary>Vector of a panel along the span.</summary>
        public float3 Spanwise(int i, int j) =>
            0.5f * (Corners[Corner(i, j + 1)] + Corners[Corner(i + 1, j + 1)] - Corners[Corner(i, j)] - Corners[Corner(i + 1, j)]);

        /// <summary>Moves the lattice to a time.</summary>
        /// <param name="beats">Time, beats.</param>
        /// <param name="stream">Velocity of the air.</param>
        /// <param name="step">Length of a step, beats.</param>
        public void Place(double beats, float3 stream, float step)
        {
            m_Motion.Evaluate(beats, m_Places, Corners, CornerVelocities);
            for (int j = 0; j <= SpanPanels; j++)
            {
                for (int i = 0; i < ChordPanels; i++)
                    Rings[Corner(i, j)] = math.lerp(Corners[Corner(i, j)], Corners[Corner(i + 1, j)], 0.25f);
                int edge = Corner(ChordPanels, j);
                Rings[edge] = Corners[edge] + m_TrailingShare * step * (stream - CornerVelocities[edge]);
            }

            for (int i = 0; i < ChordPanels; i++)
            {
                for (int j = 0; j < SpanPanels; j++)
                {
                    int ring = Ring(i, j);
                    Controls[ring] = AtPanel(Corners, i, j, 0.75f);
                    Motions[ring] = AtPanel(CornerVelocities, i, j, 0.75f);
                    Normals[ring] = math.normalizesafe(math.cross(
                        Corners[Corner(i + 1, j)] - Corners[Corner(i, j + 1)], Corners[Corner(i + 1, j + 1)] - Corners[Corner(i, j)]));
                }
            }
        }

        /// <summary>Value of the corners in the middle of a panel's width, at a share of its chord.</summary>
        public float3 AtPanel(float3[] corners, int i, int j, float share) => math.lerp(
            0.5f * (corners[Corner(i, j)] + corners[Corner(i, j + 1)]),
            0.5f * (corners[Corner(i + 1, j)] + corners[Corner(i + 1, j + 1)]), share);

        /// <summary>Shifts the history of the circulation by a step.</summary>
        public void Shift()
        {
            Array.Copy(Before, LongBefore, RingCount);
            Array.Copy(Circulation, Before, RingCount);
        }

        // Rings end a quarter of a panel short of the tip, and of a root in the air: there the circulation falls to nothing as a square
        // root does, and rings to the very end would have too much. The patches of strips cover the whole wing.
        private float Station(int j)
        {
            float root = FreeRoot ? k_EndGap : 0f;
            return (j + root) / (SpanPanels + root + k_EndGap);
        }

        private float FindMeanChord()
        {
            m_Motion.Evaluate(0.0, m_Places, Corners, CornerVelocities);
            float area = 0f, span = 0f;
            for (int j = 0; j < SpanPanels; j++)
            {
                for (int i = 0; i < ChordPanels; i++)
                    area += math.length(math.cross(Chordwise(i, j), Spanwise(i, j)));
                span += math.length(Corners[Corner(0, j + 1)] + Corners[Corner(ChordPanels, j + 1)]
                    - Corners[Corner(0, j)] - Corners[Corner(ChordPanels, j)]) / 2f;
            }

            if (!(span > 0f && area > 0f) || !math.isfinite(area))
            {
                throw new ArgumentException(FormattableString.Invariant(
                    $"A wing has an area of {area} and a span of {span}; both are above 0."));
            }
            return area / span;
        }
    }
}
