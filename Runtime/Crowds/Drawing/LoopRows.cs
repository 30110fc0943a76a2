using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>The rows of a loop in the texture.</summary>
    internal struct LoopRows
    {
        public float frequency;
        public int first;
        public int count;

        /// <summary>The loop of a number; the last one for a number that no loop has, below 0 too.</summary>
        public static LoopRows Of(NativeArray<LoopRows> loops, int loop) => loops[(int)math.min((uint)loop, (uint)loops.Length - 1u)];

        /// <summary>The rows before and after a phase, and how far it lies between them.</summary>
        public float3 At(float phase)
        {
            float frame = phase * count;
            int before = math.min((int)frame, count - 1), after = before + 1 == count ? 0 : before + 1;
            return new float3(first + before, first + after, frame - before);
        }
    }
}
