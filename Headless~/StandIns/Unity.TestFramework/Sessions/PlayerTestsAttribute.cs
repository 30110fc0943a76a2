using System;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using Unity.StandIns;

namespace StandIns;

/// <summary>
/// Runs the tests of an assembly as Unity's Test Runner does: those of one namespace in play mode, which lasts from one to the next,
/// all others in edit mode; with UnitySetUp and UnityTearDown; and an error that a test logs and does not expect fails it.
/// </summary>
[StandInExtension]
[AttributeUsage(AttributeTargets.Assembly)]
public sealed class PlayerTestsAttribute(string playModeNamespace) : Attribute, ITestAction
{
    /// <summary>Tests of this namespace, and of those within it, play.</summary>
    public string PlayModeNamespace { get; } = playModeNamespace;

    public ActionTargets Targets => ActionTargets.Test;

    public void BeforeTest(ITest test)
    {
        string home = test.TypeInfo?.Namespace ?? "";
        bool plays = home == PlayModeNamespace || home.StartsWith(PlayModeNamespace + ".", StringComparison.Ordinal);
        TestSession.Begin(test, plays);
    }

    public void AfterTest(ITest test) => TestSession.End(test);
}
