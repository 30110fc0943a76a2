using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Arrays that the two jobs run over, rebuilt only when wings come or go, and the workers' scratch blocks.</summary>
    internal sealed unsafe class JobArrays : IDisposable
    {
        /// <summary>
        /// Number of quads of one index of the skinning job: about 2000 vertices, ten microseconds; each index has a palette of its own.
        /// </summary>
        private const int k_QuadsPerChunk = 512;

        private readonly BodyTable m_Bodies;
        private NativeArray<WingPack> m_Packs;
        private NativeArray<SkinTarget> m_Targets;
        private NativeArray<SkinChunk> m_Chunks;
        private NativeArray<ChunkBounds> m_Bounds;
        private NativeArray<float4> m_NoJoints = new NativeArray<float4>(1, Allocator.Persistent);
        private int m_PackCount;
        private int m_ChunkCount;
        private bool m_Stale;

        private RigSize m_ScratchSize;
        private long m_ScratchStride;
        private byte* m_Scratch;

        public JobArrays(BodyTable bodies) => m_Bodies = bodies;

        /// <summary>Jobs scheduled so far.</summary>
        public long JobCount { get; private set; }

        /// <summary>Number that changes whenever packs move or are stepped: earlier readings are then out of date.</summary>
        public int Version { get; private set; }

        /// <summary>Takes over the results of the jobs, before packs or wings are rearranged.</summary>
        public void Download(IReadOnlyList<PackMemory> packs, List<WingEntry> entries)
        {
            Version++;
            if (m_Stale)
                return;
            m_Stale = true;
            for (int k = 0; k < m_PackCount; k++)
            {
                packs[k].view.substeps = m_Packs[k].substeps;
                packs[k].view.slotStride = m_Packs[k].slotStride;
            }

            foreach (WingEntry entry in entries)
            {
                if (entry != null)
                    entry.bounds = Merged(entry);
            }
        }

        /// <summary>Lays out the jobs' arrays for the current packs and wings, if any were rearranged.</summary>
        public void Upload(IReadOnlyList<PackMemory> packs, List<WingEntry> entries)
        {
            if (!m_Stale)
                return;
            m_Stale = false;
            m_PackCount = packs.Count;
            GrowingArray.Reserve(ref m_Packs, m_PackCount);
            RigSize size = default;
            for (int k = 0; k < m_PackCount; k++)
            {
                packs[k].index = k;
                packs[k].view.carries = false;
                m_Packs[k] = packs[k].view;
                size = RigSize.Max(size, RigSize.Of(packs[k].view.rig));
            }

            m_Bodies.Layout(packs);
            ReserveScratch(size);
            int chunks = 0, targets = 0;
            foreach (WingEntry entry in entries)
            {
                if (entry == null)
                    continue;
                MarkCarrier(entry);
                targets++;
                entry.chunkCount = entry.HasJoints ? 1 : (entry.rig.View.quadCount + k_QuadsPerChunk - 1) / k_QuadsPerChunk;
                chunks += entry.chunkCount;
            }

            GrowingArray.Reserve(ref m_Targets, targets);
            GrowingArray.Reserve(ref m_Chunks, chunks);
            GrowingArray.Reserve(ref m_Bounds, chunks);
            m_ChunkCount = 0;
            int target = 0;
            foreach (WingEntry entry in entries)
            {
                if (entry != null)
                    Place(entry, target++);
            }
        }

        public JobHandle ScheduleStep(in ClockTimes clocks, JobHandle after)
        {
            Version++;
            JobCount++;
            var job = new StepWingsJob
            {
                clocks = clocks,
                scratchSize = m_ScratchSize,
                scratchStride = m_ScratchStride,
                scratch = m_Scratch,
                groups = m_Bodies.Groups,
                lists = m_Bodies.Lists(null),
                packs = m_Packs,
            };
            job.Validate(m_Bodies.GroupCount);
            return job.ScheduleParallel(m_Bodies.GroupCount, 1, after);
        }

        public JobHandle ScheduleSkin(in ClockTimes clocks, NativeArray<float4> joints, JobHandle after)
        {
            JobCount++;
            var job = new SkinWingsJob
            {
                clocks = clocks,
                chunks = m_Chunks,
                targets = m_Targets,
                packs = m_Packs,
                bounds = m_Bounds,
                joints = joints.IsCreated ? joints : m_NoJoints,
            };
            job.Validate(m_ChunkCount);
            return job.ScheduleParallel(m_ChunkCount, 1, after);
        }

        /// <summary>Pack with the results of the jobs.</summary>
        public WingPack Pack(PackMemory pack) => m_Stale ? pack.view : m_Packs[pack.index];

        /// <summary>Derives the values that depend on a wing's parameters, after a change; restarts the wing where asked.</summary>
        public void Refresh(PackMemory pack, int lane, bool restart)
        {
            PackStep.Derive(pack.view);
            if (restart)
                PackReset.Restart(pack.view, Scratch(pack), Lanes(pack, lane));
        }

        /// <summary>Advances the beat of a wing by some time, seconds, and puts the wing into the driven pose.</summary>
        public void Resume(PackMemory pack, int lane, float seconds) =>
            PackReset.Resume(pack.view, Scratch(pack), Lanes(pack, lane), seconds);

        /// <summary>Moves a wing to the phase of another one, in the driven pose.</summary>
        public void Follow(PackMemory pack, int lane, PackMemory leader, int leaderLane)
        {
            // Resuming settles on the present frequency; the glide from the last one is taken over after it, so that the two stay together.
            BeatState beat = *leader.view.beat;
            TakeClock(pack, lane, beat, leaderLane);
            Resume(pack, lane, 0f);
            TakeClock(pack, lane, beat, leaderLane);
        }

        /// <summary>Steps the wings of one owner on the calling thread.</summary>
        public void StepNow(IReadOnlyList<PackMemory> packs, int owner, float dt)
        {
            Version++;
            GroupLists lists = m_Bodies.Lists((WingPack*)m_Packs.GetUnsafePtr());
            for (int k = 0; k < m_Bodies.GroupCount; k++)
            {
                PackMemory pack = packs[lists.packList[m_Bodies.Groups[k].firstPack]];
                if (pack.packKey.clock == WingUpdateMode.Manual && pack.packKey.owner == owner)
                    GroupStep.Run(m_Bodies.Groups[k], lists, Scratch(pack), dt, 0);
            }
        }

        /// <summary>Sets whether the skinning job deforms a wing.</summary>
        public void SetSkinned(WingEntry entry, bool skinned)
        {
            entry.skinned = skinned;
            entry.displaces &= skinned;
            Write(entry);
        }

        /// <summary>Sets whether the skinning job deforms the vertices of the smaller mesh alone.</summary>
        public void SetSmaller(WingEntry entry, bool smaller)
        {
            entry.smaller = smaller;
            entry.displaces = false;
            Write(entry);
        }

        /// <summary>Sets whether a wing's vertices are those of the last picture, from which displacements lead.</summary>
        public void SetDisplaces(WingEntry entry, bool displaces)
        {
            if (entry.displaces == displaces)
                return;
            entry.displaces = displaces;
            Write(entry);
        }

        /// <summary>Takes over where a wing's joints are written.</summary>
        public void SetPlace(WingEntry entry) => Write(entry);

        /// <summary>Bounds of one wing's deformed vertices.</summary>
        /// <param name="entry">The wing.</param>
        /// <param name="joints">Memory in which joints are placed.</param>
        public Bounds Bounds(WingEntry entry, NativeArray<float4> joints)
        {
            DualQuaternion* palette = entry.placed > 0 ? (DualQuaternion*)Pointer(joints) + entry.placed - 1
                : (DualQuaternion*)Pointer(entry.palette);
            ChunkBounds all = palette != null ? PaletteBounds.Of(entry.rig.View, entry.rig.Frame, palette)
                : m_Stale ? entry.bounds : Merged(entry);
            return new Bounds(0.5f * (all.min + all.max), all.max - all.min);
        }

        public void Dispose()
        {
            Version++;
            GrowingArray.Free(ref m_Packs);
            GrowingArray.Free(ref m_Targets);
            GrowingArray.Free(ref m_Chunks);
            GrowingArray.Free(ref m_Bounds);
            GrowingArray.Free(ref m_NoJoints);
            if (m_Scratch != null)
                UnsafeUtility.FreeTracked(m_Scratch, Allocator.Persistent);
            m_Scratch = null;
        }

        private void Write(WingEntry entry)
        {
            if (m_Stale)
                return;
            SkinTarget target = m_Targets[entry.target];
            target.skinned = entry.skinned;
            target.smaller = entry.smaller;
            target.displaces = entry.displaces;
            target.palette = (DualQuaternion*)Pointer(entry.palette);
            target.placed = entry.placed;
            m_Targets[entry.target] = target;
        }

        private ChunkBounds Merged(WingEntry entry)
        {
            if (entry.chunkCount == 0)
                return entry.bounds;
            ChunkBounds all = m_Bounds[entry.firstChunk];
            for (int k = 1; k < entry.chunkCount; k++)
            {
                all.min = math.min(all.min, m_Bounds[entry.firstChunk + k].min);
                all.max = math.max(all.max, m_Bounds[entry.firstChunk + k].max);
            }

            return all;
        }

        private StepScratch Scratch(PackMemory pack)
        {
            ReserveScratch(RigSize.Of(pack.view.rig));
            StepScratch.Layout(m_ScratchSize, m_Scratch, out StepScratch scratch);
            return scratch;
        }

        private static void TakeClock(PackMemory pack, int lane, in BeatState beat, int from)
        {
            for (int l = 0; l < WingPack.Lanes; l++)
            {
                if (pack.Writes(lane, l))
                    pack.view.beat->TakeClock(l, beat, from);
            }
        }

        private static bool4 Lanes(PackMemory pack, int lane)
        {
            bool4 lanes = false;
            for (int l = 0; l < WingPack.Lanes; l++)
                lanes[l] = pack.Writes(lane, l);
            return lanes;
        }

        private void MarkCarrier(WingEntry entry)
        {
            if (entry.body == 0)
                return;
            entry.pack.view.carries = true;
            m_Packs[entry.pack.index] = entry.pack.view;
        }

        private void Place(WingEntry entry, int index)
        {
            entry.target = index;
            m_Targets[index] = new SkinTarget
            {
                rig = entry.rig.View,
                frame = entry.rig.Frame,
                pack = entry.pack.index,
                lane = entry.lane,
                skinned = entry.skinned,
                smaller = entry.smaller,
                vertices = (SkinnedVertex*)Pointer(entry.vertices),
                tangents = (float4*)Pointer(entry.tangents),
                packedVertices = (PackedVertex*)Pointer(entry.packedVertices),
                packedTangents = (int*)Pointer(entry.packedTangents),
                displaces = entry.displaces,
                displacements = (VertexDisplacement*)Pointer(entry.displacements),
                palette = (DualQuaternion*)Pointer(entry.palette),
                placed = entry.placed,
            };
            entry.firstChunk = m_ChunkCount;
            int quads = entry.rig.View.quadCount;
            for (int k = 0; k < entry.chunkCount; k++)
            {
                m_Bounds[m_ChunkCount] = entry.bounds;
                m_Chunks[m_ChunkCount++] = new SkinChunk
                {
                    target = index,
                    firstQuad = (int)((long)quads * k / entry.chunkCount),
                    endQuad = (int)((long)quads * (k + 1) / entry.chunkCount),
                };
            }
        }

        private static void* Pointer<T>(NativeArray<T> array) where T : struct => array.IsCreated ? array.GetUnsafePtr() : null;

        private void ReserveScratch(in RigSize size)
        {
            var grown = RigSize.Max(m_ScratchSize, size);
            long stride = StepScratch.Layout(grown, null, out _);
            if (m_Scratch != null && stride == m_ScratchStride)
                return;
            if (m_Scratch != null)
                UnsafeUtility.FreeTracked(m_Scratch, Allocator.Persistent);
            m_ScratchSize = grown;
            m_ScratchStride = stride;
            m_Scratch = (byte*)UnsafeUtility.MallocTracked(
                stride * JobsUtility.ThreadIndexCount, JobsUtility.CacheLineSize, Allocator.Persistent, 0);
            UnsafeUtility.MemClear(m_Scratch, stride * JobsUtility.ThreadIndexCount);
        }
    }
}
