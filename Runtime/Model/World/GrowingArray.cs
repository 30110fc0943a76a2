using Unity.Collections;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Native arrays that grow by doubling and are refilled afterwards.</summary>
    internal static class GrowingArray
    {
        /// <summary>Makes room for a count of elements; what the array held is lost where it grows.</summary>
        public static void Reserve<T>(ref NativeArray<T> array, int count) where T : struct
        {
            if (array.IsCreated && array.Length >= count)
                return;
            int grown = math.max(count, 2 * array.Length);
            Free(ref array);
            array = new NativeArray<T>(grown, Allocator.Persistent);
        }

        /// <summary>Frees an array, if there is one.</summary>
        public static void Free<T>(ref NativeArray<T> array) where T : struct
        {
            if (array.IsCreated)
                array.Dispose();
        }
    }
}
