using Unity.Profiling.LowLevel.Unsafe;

namespace Unity.Profiling;

public readonly struct ProfilerCategory
{
    private readonly ushort _id;

    private ProfilerCategory(ushort id) => _id = id;

    public static ProfilerCategory Scripts => new(ProfilerUnsafeUtility.CategoryScripts);

    public static implicit operator ushort(ProfilerCategory category) => category._id;
}
