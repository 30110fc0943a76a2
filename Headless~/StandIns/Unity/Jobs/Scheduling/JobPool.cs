using System.Collections.Generic;

namespace Unity.Jobs;

/// <summary>Records of one type of job that wait to be used again, so that scheduling allocates nothing once warm.</summary>
internal static class JobPool<TRecord> where TRecord : JobRecord, new()
{
    private static readonly Stack<TRecord> s_Free = new(4);

    public static TRecord Take() => s_Free.TryPop(out TRecord record) ? record : new TRecord();

    public static void Return(TRecord record) => s_Free.Push(record);
}
