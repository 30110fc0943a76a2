using System.Runtime.CompilerServices;

namespace Unity.Collections;

/// <summary>
/// State that all copies of a container check: an even version, made odd while pending jobs keep the main thread from reading or writing. A
/// job's copies check a cell of their own, which is never odd.
/// </summary>
internal struct SafetyCell
{
    public int read;
    public int write;
    public int container;
}

/// <summary>The right of one copy of a container to its memory: it may read or write while the key fits the cell.</summary>
internal unsafe struct SafetyHandle
{
    /// <summary>A key that never fits.</summary>
    public const int Denied = 0;

    /// <summary>The <see cref="slot"/> of a copy that the main thread holds.</summary>
    public const int MainThread = -1;

    public SafetyCell* cell;
    public int readKey;
    public int writeKey;
    public int version;

    /// <summary>In a job: the container's number among those of the job type.</summary>
    public int slot;

    public readonly bool Exists => (cell->read & ~1) == version;

    public readonly bool IsOfJob => slot != MainThread;

    public readonly bool RefusesRead
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => cell->read != readKey;
    }

    public readonly bool RefusesWrite
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => cell->write != writeKey;
    }
}
