using System;
using System.Diagnostics;

namespace Unity.Mathematics;

/// <summary>Checks the indexers of vectors and matrices as Unity does: in builds with safety checks only.</summary>
internal static class Index
{
    public static int Checked(int index, int count)
    {
        Check(index, count);
        return index;
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    private static void Check(int index, int count)
    {
        if ((uint)index >= (uint)count)
            throw new ArgumentException($"index must be between[0...{count - 1}]");
    }
}
