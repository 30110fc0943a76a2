using System.Runtime.CompilerServices;

namespace Unity.Collections;

/// <summary>What a container's copies share: its version, and what pending jobs keep the main thread from doing.</summary>
internal struct SafetyCell
{
    public int version;
    public int blocked;
    public int container;
}

/// <summary>The right of one copy of a container to its memory; a job's copy has another cell than the main thread's.</summary>
internal unsafe struct SafetyHandle
{
    /// <summary>A pending job writes the container.</summary>
    public const int ReadBlocked = 1;

    /// <summary>A pending job uses the container.</summary>
    public const int WriteBlocked = 2;

    /// <summary>The job has declared the container as write-only.</summary>
    public const int ReadDenied = 4;

    /// <summary>The job has declared the container as read-only.</summary>
    public const int WriteDenied = 8;

    private const int k_Denied = ReadDenied | WriteDenied;

    /// <summary>From this bit on: the container's number among those of the job type.</summary>
    public const int FieldShift = 8;

    public SafetyCell* cell;
    public int version;

    // Which of the above this copy obeys.
    public int obeys;

    /// <summary>A job's copy, not the main thread's.</summary>
    public readonly bool IsOfJob => (obeys & (ReadBlocked | WriteBlocked)) == 0;

    public readonly bool Exists => cell->version == version;

    public readonly bool RefusesRead
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => cell->version != version || ((cell->blocked | k_Denied) & obeys & (ReadBlocked | ReadDenied)) != 0;
    }

    public readonly bool RefusesWrite
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => cell->version != version || ((cell->blocked | k_Denied) & obeys & (WriteBlocked | WriteDenied)) != 0;
    }
}
