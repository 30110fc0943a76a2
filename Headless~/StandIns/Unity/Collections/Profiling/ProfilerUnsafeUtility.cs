using System;
using Unity.StandIns;

namespace Unity.Profiling.LowLevel.Unsafe;

public static unsafe class ProfilerUnsafeUtility
{
    public const ushort CategoryScripts = 1;

    /// <summary>Memory for one value that is looked at at the end of each frame; only whole numbers of four bytes here.</summary>
    public static void* CreateCounterValue(out IntPtr counterPtr, string name, ushort categoryId, MarkerFlags flags, byte dataType,
        byte dataUnit,
        int dataSize, ProfilerCounterOptions counterOptions)
    {
        if (dataType != (byte)ProfilerMarkerDataType.Int32 || dataSize != sizeof(int))
            throw new ArgumentException($"The counter '{name}' has {dataSize} bytes of type {dataType}; only Int32 can be counted here.");
        if (counterOptions != ProfilerCounterOptions.FlushOnEndOfFrame)
            throw new ArgumentException($"The counter '{name}' has options {counterOptions}; only FlushOnEndOfFrame is known here.");
        return ProfilerCounters.Add(categoryId, name, out counterPtr);
    }
}
