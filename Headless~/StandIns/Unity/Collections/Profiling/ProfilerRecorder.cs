using System;
using Unity.StandIns;

namespace Unity.Profiling;

/// <summary>Reads a counter; it may be made before the counter is.</summary>
public struct ProfilerRecorder : IDisposable
{
    private readonly ushort _category;
    private string _name;

    private ProfilerRecorder(ProfilerCategory category, string name) => (_category, _name) = (category, name);

    public readonly bool Valid => _name != null && ProfilerCounters.Has(_category, _name);

    /// <summary>The value at the end of the last frame.</summary>
    public readonly long LastValue => Valid ? ProfilerCounters.Last(_category, _name) : 0L;

    public static ProfilerRecorder StartNew(ProfilerCategory category, string statName, int capacity = 1,
        ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) => new(category, statName);

    public void Dispose() => _name = null;
}
