using NUnit.Framework;

namespace Unity.Tests;

/// <summary>What the build under test can do.</summary>
internal static class TestBuild
{
    /// <summary>Leaves a test out in builds without safety checks.</summary>
    public static void RequireChecks()
    {
#if !ENABLE_UNITY_COLLECTIONS_CHECKS
        Assert.Ignore("This build has no safety checks.");
#endif
    }
}
