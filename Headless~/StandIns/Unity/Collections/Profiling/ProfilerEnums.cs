using System;

namespace Unity.Profiling.LowLevel
{
    [Flags]
    public enum MarkerFlags : ushort
    {
        Default = 0,
    }

    public enum ProfilerMarkerDataType : byte
    {
        Int32 = 2,
    }
}

namespace Unity.Profiling
{
    public enum ProfilerMarkerDataUnit : byte
    {
        Undefined = 0,
        Count = 3,
    }

    [Flags]
    public enum ProfilerCounterOptions : ushort
    {
        None = 0,
        FlushOnEndOfFrame = 2,
        ResetToZeroOnFlush = 4,
    }

    [Flags]
    public enum ProfilerRecorderOptions
    {
        None = 0,
        StartImmediately = 1,
        WrapAroundWhenCapacityReached = 8,
        SumAllSamplesInFrame = 16,
        Default = 24,
    }
}
