using System;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Draws the insects that a camera sees, some hundreds a call: matrices straight from native memory, rows and tints by a property
    /// block.
    /// </summary>
    internal sealed class CrowdBatches : IDisposable
    {
        /// <summary>Insects of one call where a device binds 64 kB: two matrices of each fill them.</summary>
        public const int MostBatch = 500;

        /// <summary>Insects of one call where a device binds 16 kB, the least that OpenGL ES 3 and WebGL 2 promise.</summary>
        public const int LeastBatch = 125;

        private const int k_BytesPerInsect = 2 * k_BytesPerMatrix, k_BytesPerMatrix = 64;

        private static readonly int s_Rows = Shader.PropertyToID("_BakeRows"), s_NextRows = Shader.PropertyToID("_BakeNextRows"),
            s_Tint = Shader.PropertyToID("_BakeTint"), s_LastRows = Shader.PropertyToID("_BakeLastRows"),
            s_LastNextRows = Shader.PropertyToID("_BakeLastNextRows");

        private readonly Vector4[] m_Rows = new Vector4[MostBatch], m_NextRows = new Vector4[MostBatch], m_Tints = new Vector4[MostBatch];
        private readonly Vector4[] m_LastRows, m_LastNextRows;
        private readonly MaterialPropertyBlock m_Properties = new MaterialPropertyBlock();
        private CrowdGatherJob m_Job;

        /// <param name="moves">Whether insects are drawn with motion vectors.</param>
        public CrowdBatches(bool moves)
        {
            int last = moves ? MostBatch : 0;
            m_LastRows = new Vector4[last];
            m_LastNextRows = new Vector4[last];
            m_Job = new CrowdGatherJob
            {
                moves = moves,
                matrices = new NativeArray<float4x4>(MostBatch + last, Allocator.Persistent),
                rows = new NativeArray<float4>(MostBatch, Allocator.Persistent),
                nextRows = new NativeArray<float4>(MostBatch, Allocator.Persistent),
                tints = new NativeArray<float4>(MostBatch, Allocator.Persistent),
                lastRows = new NativeArray<float4>(last, Allocator.Persistent),
                lastNextRows = new NativeArray<float4>(last, Allocator.Persistent),
                corners = new NativeArray<float3>(2, Allocator.Persistent),
            };
        }

        /// <summary>
        /// Insects that this device draws at once, <see cref="LeastBatch"/> to <see cref="MostBatch"/>. More in one call would be split by
        /// the engine, unseen and not counted. Shaders for Vulkan on phones and for Switch hold 250.
        /// </summary>
        public static int BatchSize { get; } = BatchFor(
            SystemInfo.maxConstantBufferSize,
            (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Vulkan && Application.isMobilePlatform)
                || SystemInfo.graphicsDeviceType == GraphicsDeviceType.Switch);

        /// <summary>True where insects are drawn with motion vectors.</summary>
        public bool Moves => m_Job.moves;

        /// <summary>Calls since <see cref="Begin"/>.</summary>
        public int Calls { get; private set; }

        /// <summary>Triangles since <see cref="Begin"/>.</summary>
        public long Triangles { get; private set; }

        /// <summary>Insects at once on a device.</summary>
        /// <param name="bytes">Largest constant buffer; 0 where it is not known.</param>
        /// <param name="isHalf">True where shaders hold half as many.</param>
        public static int BatchFor(int bytes, bool isHalf)
        {
            int most = isHalf ? MostBatch / 2 : MostBatch;
            return bytes <= 0 ? most : math.clamp(bytes / k_BytesPerInsect, LeastBatch, most);
        }

        /// <summary>Starts to count a frame.</summary>
        public void Begin()
        {
            Calls = 0;
            Triangles = 0;
        }

        /// <summary>Draws what one camera sees.</summary>
        /// <param name="insect">Meshes and materials.</param>
        /// <param name="buffers">What is in sight.</param>
        /// <param name="look">Camera, layers, shadows and motion vectors; material, bounds and properties are filled in.</param>
        public void Draw(BakedInsect insect, CrowdBuffers buffers, RenderParams look)
        {
            look.matProps = m_Properties;
            CrowdGatherJob job = m_Job;
            job.seen = buffers.seen;
            job.spheres = buffers.spheres;
            job.From(buffers.instances);
            int start = 0;
            for (int size = 0; size < insect.Sizes.Count; size++)
            {
                CrowdSize drawn = insect.Sizes[size];
                int end = start + buffers.counts[size];
                Triangles += (long)drawn.triangles * (end - start);
                for (job.start = start; job.start < end; job.start += BatchSize)
                {
                    job.count = math.min(BatchSize, end - job.start);
                    Gather(job, ref look);
                    for (int part = 0; part < drawn.mesh.subMeshCount; part++)
                    {
                        look.material = insect.Materials[part];
                        Render(look, drawn.mesh, part, job);
                        Calls++;
                    }
                }

                start = end;
            }
        }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            m_Job.matrices.Dispose();
            m_Job.rows.Dispose();
            m_Job.nextRows.Dispose();
            m_Job.tints.Dispose();
            m_Job.lastRows.Dispose();
            m_Job.lastNextRows.Dispose();
            m_Job.corners.Dispose();
        }

        private static void Render(in RenderParams look, Mesh mesh, int part, in CrowdGatherJob job)
        {
            if (job.moves)
                Graphics.RenderMeshInstanced(look, mesh, part, job.matrices.Reinterpret<CrowdInstance>(k_BytesPerMatrix), job.count);
            else
                Graphics.RenderMeshInstanced(look, mesh, part, job.matrices.Reinterpret<Matrix4x4>(), job.count);
        }

        private void Gather(CrowdGatherJob job, ref RenderParams look)
        {
            job.Validate();
            job.Run();
            NativeArray<Vector4>.Copy(job.rows.Reinterpret<Vector4>(), m_Rows, job.count);
            NativeArray<Vector4>.Copy(job.nextRows.Reinterpret<Vector4>(), m_NextRows, job.count);
            NativeArray<Vector4>.Copy(job.tints.Reinterpret<Vector4>(), m_Tints, job.count);
            m_Properties.SetVectorArray(s_Rows, m_Rows);
            m_Properties.SetVectorArray(s_NextRows, m_NextRows);
            m_Properties.SetVectorArray(s_Tint, m_Tints);
            if (job.moves)
            {
                NativeArray<Vector4>.Copy(job.lastRows.Reinterpret<Vector4>(), m_LastRows, job.count);
                NativeArray<Vector4>.Copy(job.lastNextRows.Reinterpret<Vector4>(), m_LastNextRows, job.count);
                m_Properties.SetVectorArray(s_LastRows, m_LastRows);
                m_Properties.SetVectorArray(s_LastNextRows, m_LastNextRows);
            }

            var box = new Bounds();
            box.SetMinMax(job.corners[0], job.corners[1]);
            look.worldBounds = box;
        }
    }
}
