using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Alate
{
    /// <summary>First of the two jobs of a frame: all substeps of the fixed steps that are due; index = packs of four wings with the bodies that they carry.</summary>
    [BurstCompile]
    internal unsafe struct StepWingsJob : IJobFor
    {
        // Input
        public ClockTimes clocks;
        public RigSize scratchSize;
        public long scratchStride;

        [ReadOnly] public NativeArray<PackGroup> groups;
        public GroupLists lists;

        // Working memory, one block per worker.
        [NativeDisableUnsafePtrRestriction] public byte* scratch;
        [NativeSetThreadIndex] public int threadIndex;

        // Output; a group writes its own packs and bodies.
        [NativeDisableParallelForRestriction] public NativeArray<WingPack> packs;

        public void Execute(int index)
        {
            StepScratch.Layout(scratchSize, scratch + threadIndex * scratchStride, out StepScratch block);
            PackGroup group = groups[index];
            GroupLists all = lists;
            all.packs = (WingPack*)packs.GetUnsafePtr();
            ClockTime clock = clocks[all.Pack(group, 0).clock];
            for (int step = clock.count; step > 0; step--)
                GroupStep.Run(group, all, block, clock.length, clock.substeps);
        }
    }
}
