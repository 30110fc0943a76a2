using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;
using Unity.StandIns;

namespace UnityEngine.TestTools;

/// <summary>A test that is a routine: what it yields is waited for while the player loop ticks.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTestAttribute : CombiningStrategyAttribute, IImplyFixture, ISimpleTestBuilder, ITestBuilder
{
    public UnityTestAttribute() : base(new CombinatorialStrategy(), new ParameterDataSourceProvider())
    {
    }

    TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
        new NUnitTestCaseBuilder().BuildTestMethod(new RoutineMethod(method), suite, null);

    IEnumerable<TestMethod> ITestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
        method.GetParameters().Any() ? BuildFrom(new RoutineMethod(method), suite) : [((ISimpleTestBuilder)this).BuildFrom(method, suite)];
}
