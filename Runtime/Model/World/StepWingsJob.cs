using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Alate
{
    /// <summary>First of the two jobs of a frame: all substeps of the fixed steps that are due; index = pack of four wings.</summary>
    [BurstCompile]
    internal unsafe struct StepWingsJob : IJobFor
    {
        // Input
        public ClockTimes clocks;
        public RigSize scratchSize;
        public long scratchStride;

        // Working memory, one block per worker.
        [NativeDisableUnsafePtrRestriction] public byte* scratch;
        [NativeSetThreadIndex] public int threadIndex;

        // Output
        public NativeArray<WingPack> packs;

        public void Execute(int index)
        {
            StepScratch.Layout(scratchSize, scratch + threadIndex * scratchStride, out StepScratch block);
            WingPack pack = packs[index];
            ClockTime clock = clocks[pack.clock];
            for (int step = clock.count; step > 0; step--)
                PackStep.Run(ref pack, block, clock.length);
            packs[index] = pack;
        }
    }
}
