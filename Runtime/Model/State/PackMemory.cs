using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Owns the block behind one <see cref="WingPack"/>. Every byte of it belongs to a float4, so lanes can be copied blindly.
    /// </summary>
    internal sealed unsafe class PackMemory : IDisposable
    {
        private byte* m_Block;
        private readonly long m_Bytes;

        /// <summary>Indices of the wings in the lanes; −1 where a lane is a copy.</summary>
        public readonly int[] wings = { -1, -1, -1, -1 };

        /// <summary>Size of the block.</summary>
        public long Bytes => m_Bytes;

        /// <summary>View for the job.</summary>
        public WingPack view;

        /// <summary>Key of the wings that may share the pack.</summary>
        public readonly PackKey packKey;

        /// <summary>Position among the packs of the world.</summary>
        public int index;

        /// <summary>Number of lanes that hold wings of their own: always the first ones.</summary>
        public int Count { get; private set; }

        /// <summary>Allocates a pack for a rig, its lanes empty.</summary>
        public PackMemory(in RigView rig, in ModelOptions options, in PackKey packKey = default)
        {
            m_Bytes = Layout(rig.jointCount, rig.boneCount, rig.chainCount, null, out _);
            m_Block = (byte*)UnsafeUtility.MallocTracked(m_Bytes, 64, Allocator.Persistent, 0);
            UnsafeUtility.MemClear(m_Block, m_Bytes);
            Layout(rig.jointCount, rig.boneCount, rig.chainCount, m_Block, out view);
            view.rig = rig;
            view.options = options;
            view.clock = packKey.clock;
            view.detail = packKey.detail;
            this.packKey = packKey;
        }

        /// <summary>Puts a new wing into the next lane; the first one also fills the lanes that are empty.</summary>
        /// <returns>Its lane.</returns>
        public int Add(int wing, in WingParameters parameters, in WingSurroundings surroundings)
        {
            int lane = Count++;
            wings[lane] = wing;
            for (int l = lane; l < (lane == 0 ? WingPack.Lanes : lane + 1); l++)
            {
                view.Set(l, parameters);
                view.surroundings->Set(l, surroundings);
                view.parameters->drive.Set(l, default, false);
                view.substeps[l] = 0f;
                view.slotStride[l] = 1f;
            }

            view.readings->resets[lane] = 0f;
            return lane;
        }

        /// <summary>Copies the state of a wing from another pack, or another lane, into a lane.</summary>
        public void CopyWing(PackMemory from, int fromLane, int lane)
        {
            for (int l = 0; l < WingPack.Lanes; l++)
            {
                if (Writes(lane, l))
                    CopyLane(from, fromLane, l);
            }

            wings[lane] = from.wings[fromLane];
        }

        /// <summary>Makes a pack of its own that holds one wing's state.</summary>
        public PackMemory Snapshot(int lane)
        {
            var copy = new PackMemory(view.rig, view.options) { Count = 1 };
            copy.CopyWing(this, lane, 0);
            return copy;
        }

        /// <summary>
        /// Returns true where a write to a wing also goes to a lane: to its own lane, and from the first lane to the empty ones.
        /// </summary>
        public bool Writes(int wingLane, int lane) => lane == wingLane || (wingLane == 0 && lane >= Count);

        /// <summary>Gives up the last lane; it becomes a copy of the first.</summary>
        public void RemoveLast()
        {
            int lane = --Count;
            if (lane > 0)
                CopyLane(this, 0, lane);
            wings[lane] = -1;
        }

        /// <summary>Starts or stops keeping the aerodynamic loads of every patch for tools.</summary>
        public void Record(bool on)
        {
            if (on == (view.recordedLoads != null))
                return;
            if (on)
            {
                long bytes = (long)view.RecordedCount * sizeof(float4);
                view.recordedLoads = (PatchLoad*)UnsafeUtility.MallocTracked(bytes, 64, Allocator.Persistent, 0);
                UnsafeUtility.MemClear(view.recordedLoads, bytes);
                return;
            }

            UnsafeUtility.FreeTracked(view.recordedLoads, Allocator.Persistent);
            view.recordedLoads = null;
        }

        public void Dispose()
        {
            if (m_Block == null)
                return;
            Record(false);
            UnsafeUtility.FreeTracked(m_Block, Allocator.Persistent);
            m_Block = null;
        }

        private void CopyLane(PackMemory from, int fromLane, int lane)
        {
            float* source = (float*)from.m_Block;
            float* target = (float*)m_Block;
            long count = m_Bytes / sizeof(float4);
            for (long k = 0; k < count; k++)
                target[4 * k + lane] = source[4 * k + fromLane];
            view.substeps[lane] = from.view.substeps[fromLane];
            view.slotStride[lane] = from.view.slotStride[fromLane];
        }

        /// <summary>Returns the number of float4 that a substep changes, poses of the step apart; grows with each of the counts.</summary>
        public static int StateCount(int joints, int bones, int chains)
        {
            Layout(joints, bones, chains, null, out WingPack view);
            return view.stateCount;
        }

        private static long Layout(int joints, int bones, int chains, byte* block, out WingPack view)
        {
            var carver = new BlockCarver(block);
            view = default;
            view.slotStride = 1f;
            view.state = (float4*)block;
            view.parameters = (LaneParameters*)carver.Carve<LaneParameters>(1);
            view.surroundings = (LaneSurroundings*)carver.Carve<LaneSurroundings>(1);
            view.series = (float4*)carver.Carve<float4>(WingKinematics.Count);
            view.inflow = (LaneInflow*)carver.Carve<LaneInflow>(1);
            view.air = (LaneAir*)carver.Carve<LaneAir>(1);
            view.momentum = (LaneMomentum*)carver.Carve<LaneMomentum>(1);
            view.readings = (PackReadings*)carver.Carve<PackReadings>(1);
            view.beat = (BeatState*)carver.Carve<BeatState>(1);
            view.bendStiffness = (float4*)carver.Carve<float4>(bones);
            view.bendDamping = (float4*)carver.Carve<float4>(bones);
            view.torsionStiffness = (float4*)carver.Carve<float4>(bones);
            view.torsionDamping = (float4*)carver.Carve<float4>(bones);
            view.bendStiffening = (float4*)carver.Carve<float4>(bones);
            view.chainDelays = (float4*)carver.Carve<float4>(chains);
            view.bendAngles = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            view.bendRates = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            view.earlierAngles = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            view.earlierRates = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            view.lastSubstep = (float4*)carver.Carve<float4>(1);
            view.bentRotations = (SoaQuaternion*)carver.Carve<SoaQuaternion>(bones);
            view.drivenRotations = (SoaQuaternion*)carver.Carve<SoaQuaternion>(bones);
            view.drivenPositions = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.drivenLags = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.normalSpeeds = (float4*)carver.Carve<float4>(joints);
            view.earlierNormalSpeeds = (float4*)carver.Carve<float4>(joints);
            view.offsets = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.offsetRates = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.earlierOffsets = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.earlierOffsetRates = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            view.motions = (JointMotion*)carver.Carve<JointMotion>(joints);
            view.pose = (JointPose*)carver.Carve<JointPose>(joints);
            view.stateCount = (int)(carver.Size / sizeof(float4));
            view.slots = (JointPose*)carver.Carve<JointPose>(joints * WingPack.PoseSlots);
            return carver.Size;
        }
    }
}
