using System;
using Unity.StandIns;

namespace Unity.Profiling;

/// <summary>A named stretch of work in Unity's profiler; its time is kept while <see cref="MarkerTimes"/> are on.</summary>
public readonly struct ProfilerMarker
{
    private readonly int _index;

    public ProfilerMarker(string name) => _index = MarkerTimes.IndexOf(name);

    public void Begin() => MarkerTimes.Begin(_index);

    public void End() => MarkerTimes.End(_index);

    public AutoScope Auto()
    {
        Begin();
        return new AutoScope(_index);
    }

    public readonly struct AutoScope : IDisposable
    {
        private readonly int _index;

        internal AutoScope(int index) => _index = index;

        public void Dispose() => MarkerTimes.End(_index);
    }
}
