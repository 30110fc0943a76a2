using System;
using System.Collections.Generic;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace UnityEngine.TestTools;

/// <summary>A test that goes on over several frames: each "yield return null" is one.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTestAttribute : CombiningStrategyAttribute, ISimpleTestBuilder, ITestBuilder, IImplyFixture, IApplyToTest
{
    public UnityTestAttribute() : base(new CombinatorialStrategy(), new ParameterDataSourceProvider())
    {
    }

    TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
        new NUnitTestCaseBuilder().BuildTestMethod(new RoutineMethod(method), suite, null);

    IEnumerable<TestMethod> ITestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
        method.GetParameters().Length == 0 ? Array.Empty<TestMethod>() : BuildFrom(new RoutineMethod(method), suite);

    void IApplyToTest.ApplyToTest(Test test)
    {
    }
}
