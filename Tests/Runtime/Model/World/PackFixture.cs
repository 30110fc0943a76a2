using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Alate.Tests
{
    /// <summary>One pack with its scratch, for tests of single kernels.</summary>
    internal sealed unsafe class PackFixture : IDisposable
    {
        public readonly WingRig rig;
        public readonly PackMemory memory;
        public readonly StepScratch scratch;
        private readonly byte* m_Scratch;

        /// <summary>Four wings with the same parameters; takes over one use of the rig.</summary>
        public PackFixture(WingRig rig, in WingParameters parameters, in WingSurroundings surroundings = default)
        {
            this.rig = rig;
            memory = new PackMemory(rig.View, parameters.options);
            for (int lane = 0; lane < WingPack.Lanes; lane++)
                memory.Add(lane, parameters, surroundings);
            var size = RigSize.Of(rig.View);
            long bytes = StepScratch.Layout(size, null, out _);
            m_Scratch = (byte*)UnsafeUtility.Malloc(bytes, 64, Allocator.Persistent);
            UnsafeUtility.MemClear(m_Scratch, bytes);
            StepScratch.Layout(size, m_Scratch, out scratch);
            PackStep.Derive(memory.view);
            PackReset.Restart(memory.view, scratch, true);
        }

        /// <summary>The pack.</summary>
        public ref WingPack Pack => ref memory.view;

        /// <summary>One substep of 24 in a beat, seconds.</summary>
        public float Substep => 1f / (24f * Pack.beat->frequency.x);

        public void Dispose()
        {
            UnsafeUtility.Free(m_Scratch, Allocator.Persistent);
            memory.Dispose();
            rig.Release();
        }
    }
}
