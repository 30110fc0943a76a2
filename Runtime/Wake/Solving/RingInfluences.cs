using System;
using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Velocities that rings of unit circulation on the wings induce at points of the wings: those of the wing's own rings, without
    /// cores, and those of all others and of mirror images, with them.
    /// </summary>
    internal sealed class RingInfluences : IDisposable
    {
        /// <summary>Vertices of a ring, closed.</summary>
        private const int k_Ring = 5;

        /// <summary>Square of the core of a wing's own rings as it feels them, squared chords: none, but for the trailing leg.</summary>
        private const float k_OwnCore = 1e-12f;
        private const int k_Lanes = 4;

        private readonly int[] m_First;

        // [wing] Place of its first point.
        private readonly int[] m_Starts;
        private readonly MirrorImages m_Images;
        private readonly int m_Count, m_Stride;
        private readonly bool m_OnOneThread;

        // [ring · 2 · 5] The ring as its own wing feels it, then as others do.
        private NativeArray<VortexVertex> m_Vertices;
        private NativeArray<int2> m_OwnQuartets;
        private NativeArray<SoaFloat3> m_Points, m_Influences;

        /// <summary>Takes the memory.</summary>
        /// <param name="first">[wing] First ring of each wing, and one past the last.</param>
        /// <param name="images">Planes of the flow.</param>
        /// <param name="onOneThread">True to compute on the calling thread, without jobs.</param>
        public RingInfluences(int[] first, MirrorImages images, bool onOneThread = false)
        {
            m_First = first;
            m_OnOneThread = onOneThread;
            m_Images = images;
            m_Count = first[first.Length - 1];
            // Each wing's points begin a quartet pair of their own, so that one core suits all of a block.
            m_Starts = new int[first.Length];
            for (int wing = 1; wing < first.Length; wing++)
                m_Starts[wing] = m_Starts[wing - 1] + (first[wing] - first[wing - 1] + 7) / 8 * 8;
            m_Stride = m_Starts[first.Length - 1];
            m_Vertices = new NativeArray<VortexVertex>(2 * k_Ring * m_Count, Allocator.Persistent);
            m_OwnQuartets = new NativeArray<int2>(m_Count, Allocator.Persistent);
            m_Points = new NativeArray<SoaFloat3>(images.Count * m_Stride / k_Lanes, Allocator.Persistent);
            m_Influences = new NativeArray<SoaFloat3>(m_Points.Length * m_Count, Allocator.Persistent);
            for (int wing = 0; wing + 1 < first.Length; wing++)
            {
                for (int ring = first[wing]; ring < first[wing + 1]; ring++)
                    m_OwnQuartets[ring] = new int2(m_Starts[wing], m_Starts[wing + 1]) / k_Lanes;
            }
        }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            m_Vertices.Dispose();
            m_OwnQuartets.Dispose();
            m_Points.Dispose();
            m_Influences.Dispose();
        }

        /// <summary>Writes the rings of a wing.</summary>
        /// <param name="wing">Index of the wing.</param>
        /// <param name="lattice">Its lattice.</param>
        /// <param name="cores">Its cores.</param>
        /// <param name="leading">False to leave out leading legs as the wing itself feels them.</param>
        public void SetRings(int wing, WingLattice lattice, in WakeCores cores, bool leading)
        {
            float own = k_OwnCore * lattice.MeanChord * lattice.MeanChord;
            for (int i = 0; i < lattice.ChordPanels; i++)
            {
                bool last = i == lattice.ChordPanels - 1;
                for (int j = 0; j < lattice.SpanPanels; j++)
                {
                    int at = 2 * k_Ring * (m_First[wing] + lattice.Ring(i, j));
                    Write(at, lattice, i, j, own, last ? cores.Shed : own, leading);
                    Write(at + k_Ring, lattice, i, j, cores.Bound, last ? cores.Shed : cores.Bound, true);
                }
            }
        }

        /// <summary>Writes a point of a wing, at which all rings are wanted.</summary>
        public void SetPoint(int wing, int ring, float3 point)
        {
            for (int image = 0; image < m_Images.Count; image++)
            {
                int at = image * m_Stride + m_Starts[wing] + ring;
                SoaFloat3 quartet = m_Points[at / k_Lanes];
                quartet[at % k_Lanes] = m_Images.Point(image, point);
                m_Points[at / k_Lanes] = quartet;
            }
        }

        /// <summary>Computes all influences.</summary>
        public void Evaluate()
        {
            var job = new InfluenceJob { vertices = m_Vertices, points = m_Points, own = m_OwnQuartets, influences = m_Influences };
            job.Validate(m_Count);
            if (!m_OnOneThread)
            {
                job.ScheduleParallel(m_Count, 8, default).Complete();
                return;
            }

            for (int k = 0; k < m_Count; k++)
                job.Execute(k);
        }

        /// <summary>Velocity at a point of a wing that a ring of unit circulation induces, itself and by its images.</summary>
        /// <param name="wing">Wing of the point.</param>
        /// <param name="ring">Ring of the point, counted within its wing.</param>
        /// <param name="source">The ring that induces, counted over all wings.</param>
        /// <param name="own">The part of it that a ring of the same wing has itself, not by images; 0 for rings of others.</param>
        public float3 Velocity(int wing, int ring, int source, out float3 own)
        {
            int quartets = m_Images.Count * m_Stride / k_Lanes;
            float3 sum = own = default;
            for (int image = 0; image < m_Images.Count; image++)
            {
                int at = image * m_Stride + m_Starts[wing] + ring;
                float3 velocity = m_Images.Direction(image, m_Influences[source * quartets + at / k_Lanes][at % k_Lanes]);
                sum += velocity;
                if (image == 0 && source >= m_First[wing] && source < m_First[wing + 1])
                    own = velocity;
            }

            return sum;
        }

        private void Write(int at, WingLattice lattice, int i, int j, float core, float trailing, bool leading)
        {
            float3 a = lattice.Rings[lattice.Corner(i, j)], b = lattice.Rings[lattice.Corner(i, j + 1)],
                c = lattice.Rings[lattice.Corner(i + 1, j + 1)], d = lattice.Rings[lattice.Corner(i + 1, j)];
            m_Vertices[at] = new VortexVertex { position = a };
            m_Vertices[at + 1] = VortexVertex.Segment(a, b, leading ? 1f : 0f, core);
            m_Vertices[at + 2] = VortexVertex.Segment(b, c, 1f, core);
            m_Vertices[at + 3] = VortexVertex.Segment(c, d, 1f, trailing);
            m_Vertices[at + 4] = VortexVertex.Segment(d, a, 1f, core);
        }

        /// <summary>Velocities of one ring at all points; index = ring.</summary>
        [BurstCompile]
        private struct InfluenceJob : IJobFor
        {
            // Input
            [ReadOnly] public NativeArray<VortexVertex> vertices;
            [ReadOnly] public NativeArray<SoaFloat3> points;

            /// <summary>[ring] First quartet of its own wing's points, and one past the last.</summary>
            [ReadOnly] public NativeArray<int2> own;

            // Output; [ring · quartets + quartet].
            [NativeDisableParallelForRestriction] public NativeArray<SoaFloat3> influences;

            [Conditional(JobFields.Checks)]
            public void Validate(int count)
            {
                JobFields.AtLeast(vertices.Length, 2 * k_Ring * count, "InfluenceJob.vertices");
                JobFields.AtLeast(own.Length, count, "InfluenceJob.own");
                JobFields.AtLeast(influences.Length, points.Length * count, "InfluenceJob.influences");
            }

            public void Execute(int ring)
            {
                for (int quartet = 0; quartet + 1 < points.Length; quartet += 2)
                {
                    bool isOwn = quartet >= own[ring].x && quartet < own[ring].y;
                    int first = 2 * k_Ring * ring + (isOwn ? 0 : k_Ring);
                    BiotSavart.Induce(
                        vertices, first, first + k_Ring, points[quartet], points[quartet + 1], out SoaFloat3 low, out SoaFloat3 high);
                    int at = ring * points.Length + quartet;
                    influences[at] = low;
                    influences[at + 1] = high;
                }
            }
        }
    }
}
