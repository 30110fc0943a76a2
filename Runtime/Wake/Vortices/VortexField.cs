using System;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Vortex segments, points, and the velocities induced there; its memory is taken once. Points come with their mirror images.
    /// </summary>
    internal sealed class VortexField : IDisposable
    {
        /// <summary>Points of one index of the job.</summary>
        private const int k_Points = 8;
        private const int k_Lanes = 4;

        /// <summary>Influences of one batch, below which waking a worker costs more than it saves.</summary>
        private const int k_Batch = 20000;

        private readonly MirrorImages m_Images;
        private readonly bool m_OnOneThread;
        private NativeArray<VortexVertex> m_Vertices;
        private NativeArray<SoaFloat3> m_Points, m_Velocities;
        private int m_Count, m_Stride;

        /// <summary>Takes the memory.</summary>
        /// <param name="vertices">Most vertices at a time.</param>
        /// <param name="points">Most points at a time, images apart.</param>
        /// <param name="images">Planes of the flow.</param>
        /// <param name="onOneThread">True to compute on the calling thread, without jobs.</param>
        public VortexField(int vertices, int points, MirrorImages images, bool onOneThread = false)
        {
            m_Images = images;
            m_OnOneThread = onOneThread;
            PointCapacity = points;
            int quartets = images.Count * Padded(points) / k_Lanes;
            m_Vertices = new NativeArray<VortexVertex>(vertices, Allocator.Persistent);
            m_Points = new NativeArray<SoaFloat3>(quartets, Allocator.Persistent);
            m_Velocities = new NativeArray<SoaFloat3>(quartets, Allocator.Persistent);
        }

        /// <summary>Most points at a time, images apart.</summary>
        public int PointCapacity { get; }

        /// <summary>Number of influences of segments on points that were computed since the start.</summary>
        public long Influences { get; private set; }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            m_Vertices.Dispose();
            m_Points.Dispose();
            m_Velocities.Dispose();
        }

        /// <summary>Drops all vertices.</summary>
        public void Clear() => m_Count = 0;

        /// <summary>Begins a chain of segments.</summary>
        public void Begin(float3 position) => m_Vertices[m_Count++] = new VortexVertex { position = position };

        /// <summary>Adds a segment from the last vertex to a place.</summary>
        /// <param name="position">Its end.</param>
        /// <param name="circulation">Γ, squared reference lengths a beat.</param>
        /// <param name="coreSquare">Square of the core's radius.</param>
        public void Add(float3 position, float circulation, float coreSquare)
        {
            m_Vertices[m_Count] = VortexVertex.Segment(m_Vertices[m_Count - 1].position, position, circulation, coreSquare);
            m_Count++;
        }

        /// <summary>Takes points, from the first one on.</summary>
        /// <param name="count">Number of points that <see cref="SetPoint"/> writes.</param>
        public void SetPointCount(int count) => m_Stride = Padded(count);

        /// <summary>Writes a point and its images.</summary>
        public void SetPoint(int index, float3 point)
        {
            for (int image = 0; image < m_Images.Count; image++)
            {
                int at = image * m_Stride + index;
                SoaFloat3 quartet = m_Points[at / k_Lanes];
                quartet[at % k_Lanes] = m_Images.Point(image, point);
                m_Points[at / k_Lanes] = quartet;
            }
        }

        /// <summary>Computes what all segments induce at all points, on all cores or on this thread.</summary>
        public void Induce()
        {
            int blocks = m_Images.Count * m_Stride / k_Points;
            var job = new InducedVelocityJob { vertices = m_Vertices, vertexCount = m_Count, points = m_Points, velocities = m_Velocities };
            job.Validate(blocks);
            Influences += (long)blocks * k_Points * m_Count;
            if (!m_OnOneThread)
            {
                job.ScheduleParallel(blocks, math.max(1, k_Batch / (k_Points * math.max(m_Count, 1))), default).Complete();
                return;
            }

            for (int k = 0; k < blocks; k++)
                job.Execute(k);
        }

        /// <summary>Velocity at a point, of the segments and all of their images.</summary>
        public float3 Velocity(int index)
        {
            float3 sum = default;
            for (int image = 0; image < m_Images.Count; image++)
            {
                int at = image * m_Stride + index;
                sum += m_Images.Direction(image, m_Velocities[at / k_Lanes][at % k_Lanes]);
            }

            return sum;
        }

        private static int Padded(int count) => (count + k_Points - 1) / k_Points * k_Points;
    }
}
