using Unity.Profiling;

namespace Alate
{
    /// <summary>Names in the profiler for each thing the system does on the main thread.</summary>
    internal static class SystemMarkers
    {
        public static readonly ProfilerMarker fixedStep = new ProfilerMarker("Alate.FixedStep");
        public static readonly ProfilerMarker frame = new ProfilerMarker("Alate.Frame");
        public static readonly ProfilerMarker renew = new ProfilerMarker("Alate.Renew");
        public static readonly ProfilerMarker admit = new ProfilerMarker("Alate.Admit");
        public static readonly ProfilerMarker tune = new ProfilerMarker("Alate.Tune");
        public static readonly ProfilerMarker watch = new ProfilerMarker("Alate.Watch");
        public static readonly ProfilerMarker sense = new ProfilerMarker("Alate.Sense");
        public static readonly ProfilerMarker detail = new ProfilerMarker("Alate.Detail");
        public static readonly ProfilerMarker schedule = new ProfilerMarker("Alate.Schedule");
        public static readonly ProfilerMarker wait = new ProfilerMarker("Alate.Wait");
        public static readonly ProfilerMarker upload = new ProfilerMarker("Alate.Upload");
        public static readonly ProfilerMarker events = new ProfilerMarker("Alate.Events");
    }
}
