using System;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using UnityEngine.TestTools;

namespace Unity.StandIns;

/// <summary>
/// Put on an assembly, runs its tests as Unity's Test Runner would: those of a namespace with a part "Editor" in edit mode,
/// all others in play mode, each in a fresh scene at time 0. A test that logs an unexpected error fails.
/// </summary>
[StandInExtension]
[AttributeUsage(AttributeTargets.Assembly)]
public sealed class UnityTestsAttribute : Attribute, ITestAction
{
    public ActionTargets Targets => ActionTargets.Test;

    public void BeforeTest(ITest test) => TestRun.Begin(!IsEditMode(test), TestExecutionContext.CurrentContext.TestObject);

    public void AfterTest(ITest test) => TestRun.End(TestExecutionContext.CurrentContext.TestObject);

    private static bool IsEditMode(ITest test) => Array.IndexOf((test.ClassName ?? "").Split('.'), "Editor") >= 0;
}
