using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Alate
{
    /// <summary>
    /// First of the two jobs of a frame: all substeps of the fixed steps that are due; index = packs of four wings with the bodies that
    /// they carry.
    /// </summary>
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

        /// <summary>Checks the fields before the job is scheduled over a number of groups.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate(int count)
        {
            JobFields.Steps(clocks);
            JobFields.AtLeast(groups.Length, count, "StepWingsJob.groups");
            JobFields.AtLeast(scratch == null ? 0 : scratchStride, StepScratch.Layout(scratchSize, null, out _), "StepWingsJob.scratch");
            for (int k = 0; k < count; k++)
            {
                PackGroup group = groups[k];
                JobFields.InRange(group.firstPack, 0, packs.Length - 1, "StepWingsJob.groups.firstPack");
                JobFields.InRange(group.packCount, 1, packs.Length - group.firstPack, "StepWingsJob.groups.packCount");
                JobFields.InRange(group.bodyCount, 0, int.MaxValue, "StepWingsJob.groups.bodyCount");
                for (int pack = 0; pack < group.packCount; pack++)
                    JobFields.InRange(lists.packList[group.firstPack + pack], 0, packs.Length - 1, "StepWingsJob.lists.packList");
            }
        }

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
