using Unity.Profiling;

namespace Alate
{
    /// <summary>Profiler markers for each phase of the system on the main thread.</summary>
    internal static class SystemMarkers
    {
        public static readonly ProfilerMarker fixedStep = new ProfilerMarker("Alate.FixedStep");
        public static readonly ProfilerMarker frame = new ProfilerMarker("Alate.Frame");
        public static readonly ProfilerMarker rebuild = new ProfilerMarker("Alate.Rebuild");
        public static readonly ProfilerMarker start = new ProfilerMarker("Alate.Start");
        public static readonly ProfilerMarker parameters = new ProfilerMarker("Alate.Parameters");
        public static readonly ProfilerMarker motion = new ProfilerMarker("Alate.Motion");
        public static readonly ProfilerMarker surroundings = new ProfilerMarker("Alate.Surroundings");
        public static readonly ProfilerMarker detail = new ProfilerMarker("Alate.Detail");
        public static readonly ProfilerMarker schedule = new ProfilerMarker("Alate.Schedule");
        public static readonly ProfilerMarker wait = new ProfilerMarker("Alate.Wait");
        public static readonly ProfilerMarker upload = new ProfilerMarker("Alate.Upload");
        public static readonly ProfilerMarker events = new ProfilerMarker("Alate.Events");
    }
}
