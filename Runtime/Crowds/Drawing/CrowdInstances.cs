using System;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Matrices, rows and tints that the shader reads of each insect, made once a frame for the cameras that see it. Those that one saw in
    /// the last frame are made beforehand, on a worker; others by the first camera that sees them. 113 bytes an insect, 209 with motion:
    /// then what they were in the last frame is kept too.
    /// </summary>
    internal struct CrowdInstances : IDisposable
    {
        private const byte k_Stale = 0, k_Made = 1, k_Seen = 2;

        /// <summary>[insect] Insect to world.</summary>
        public NativeArray<float4x4> matrices;

        /// <summary>[insect] Rows of the loop before and after the phase, the share of the latter, and that of the next loop.</summary>
        public NativeArray<float4> rows;

        /// <summary>[insect] The same rows of the next loop.</summary>
        public NativeArray<float4> nextRows;

        /// <summary>[insect] Red, green, blue; 1.</summary>
        public NativeArray<float4> tints;

        /// <summary>
        /// [insect] The matrix of the last frame, or this frame's where no camera saw the insect then; empty without motion.
        /// </summary>
        public NativeArray<float4x4> lastMatrices;

        /// <summary>[insect] The rows of the last frame, likewise.</summary>
        public NativeArray<float4> lastRows;

        /// <summary>[insect] The next loop's rows of the last frame, likewise; the last number is 1.</summary>
        public NativeArray<float4> lastNextRows;

        private NativeArray<byte> m_States;

        /// <param name="count">Insects.</param>
        /// <param name="moves">Whether the last frame is kept.</param>
        public CrowdInstances(int count, bool moves = false)
        {
            int last = moves ? count : 0;
            lastMatrices = new NativeArray<float4x4>(last, Allocator.Persistent);
            lastRows = new NativeArray<float4>(last, Allocator.Persistent);
            lastNextRows = new NativeArray<float4>(last, Allocator.Persistent);
            matrices = new NativeArray<float4x4>(count, Allocator.Persistent);
            rows = new NativeArray<float4>(count, Allocator.Persistent);
            nextRows = new NativeArray<float4>(count, Allocator.Persistent);
            tints = new NativeArray<float4>(count, Allocator.Persistent);
            m_States = new NativeArray<byte>(count, Allocator.Persistent);
        }

        /// <summary>Number of insects.</summary>
        public int Length => matrices.Length;

        /// <summary>True where the last frame is kept.</summary>
        public bool Moves => lastMatrices.Length > 0;

        /// <summary>Starts a frame for an insect.</summary>
        /// <param name="insect">Its number.</param>
        /// <param name="pose">Where it is.</param>
        /// <param name="loops">Rows of all loops.</param>
        public void Begin(int insect, in CrowdPose pose, NativeArray<LoopRows> loops)
        {
            bool wasSeen = m_States[insect] == k_Seen;
            m_States[insect] = wasSeen ? k_Made : k_Stale;
            if (!wasSeen)
                return;
            if (Moves)
                KeepLast(insect);
            Make(insect, pose, loops);
        }

        /// <summary>Has an insect ready for a camera that sees it.</summary>
        /// <param name="insect">Its number.</param>
        /// <param name="pose">Where it is.</param>
        /// <param name="loops">Rows of all loops.</param>
        public void See(int insect, in CrowdPose pose, NativeArray<LoopRows> loops)
        {
            if (m_States[insect] == k_Stale)
            {
                Make(insect, pose, loops);
                if (Moves)
                    KeepLast(insect);
            }

            m_States[insect] = k_Seen;
        }

        /// <summary>Frees the memory.</summary>
        public void Dispose()
        {
            matrices.Dispose();
            rows.Dispose();
            nextRows.Dispose();
            tints.Dispose();
            lastMatrices.Dispose();
            lastRows.Dispose();
            lastNextRows.Dispose();
            m_States.Dispose();
        }

        private void KeepLast(int insect)
        {
            lastMatrices[insect] = matrices[insect];
            lastRows[insect] = rows[insect];
            lastNextRows[insect] = new float4(nextRows[insect].xyz, 1f);
        }

        private void Make(int insect, in CrowdPose pose, NativeArray<LoopRows> loops)
        {
            float3x3 turn = new float3x3(pose.rotation) * pose.scale;
            matrices[insect] = new float4x4(
                new float4(turn.c0, 0f), new float4(turn.c1, 0f), new float4(turn.c2, 0f), new float4(pose.position, 1f));
            float share = math.isnan(pose.blend) ? 0f : math.saturate(pose.blend);
            rows[insect] = new float4(LoopRows.Of(loops, pose.loop).At(pose.phase), share);
            nextRows[insect] = new float4(LoopRows.Of(loops, pose.nextLoop).At(pose.phase), 0f);
            tints[insect] = new float4(pose.tint & 0xFF, (pose.tint >> 8) & 0xFF, (pose.tint >> 16) & 0xFF, 255f) * (1f / 255f);
        }
    }
}
