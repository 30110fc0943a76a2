namespace Unity.Tests;

/// <summary>Abilities of the build under test.</summary>
internal static class TestBuild
{
    /// <summary>Leaves a test out in builds without safety checks: Release builds, as Unity's players.</summary>
    public static void RequireChecks()
    {
#if !ENABLE_UNITY_COLLECTIONS_CHECKS
#if DEBUG
        NUnit.Framework.Assert.Fail("ENABLE_UNITY_COLLECTIONS_CHECKS is not defined: a debug build must have its safety checks.");
#else
        NUnit.Framework.Assert.Ignore("This build has no safety checks.");
#endif
#endif
    }
}
