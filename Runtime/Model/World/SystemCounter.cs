#if ENABLE_PROFILER
using Unity.Profiling;
using Unity.Profiling.LowLevel;
using Unity.Profiling.LowLevel.Unsafe;
#endif

namespace Alate
{
    /// <summary>Number in the profiler, one value a frame; empty in builds without the profiler.</summary>
    internal readonly unsafe struct SystemCounter
    {
        public static readonly SystemCounter insects = new SystemCounter("Alate Insects");
        public static readonly SystemCounter steps = new SystemCounter("Alate Steps");
        public static readonly SystemCounter resets = new SystemCounter("Alate Resets");

        private readonly int* m_Value;

        private SystemCounter(string name)
        {
#if ENABLE_PROFILER
            m_Value = (int*)ProfilerUnsafeUtility.CreateCounterValue(
                out _, name, ProfilerUnsafeUtility.CategoryScripts, MarkerFlags.Default, (byte)ProfilerMarkerDataType.Int32,
                (byte)ProfilerMarkerDataUnit.Count, sizeof(int), ProfilerCounterOptions.FlushOnEndOfFrame);
#else
            m_Value = null;
#endif
        }

        /// <summary>True where a profiler can show the number.</summary>
        public bool IsKept => m_Value != null;

        public void Set(int value)
        {
            if (m_Value != null)
                *m_Value = value;
        }
    }
}
