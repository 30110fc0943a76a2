using System;

namespace Unity.Profiling;

/// <summary>A named stretch of work in Unity's profiler; measures nothing here.</summary>
public readonly struct ProfilerMarker
{
    public ProfilerMarker(string name)
    {
        _ = name;
    }

    public void Begin()
    {
    }

    public void End()
    {
    }

    public AutoScope Auto() => default;

    public readonly struct AutoScope : IDisposable
    {
        public void Dispose()
        {
        }
    }
}
