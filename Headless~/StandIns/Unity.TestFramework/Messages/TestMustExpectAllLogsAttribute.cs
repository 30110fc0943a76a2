using System;

namespace UnityEngine.TestTools;

/// <summary>Also a warning or a plain message that is not expected fails the tests.</summary>
[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method)]
public class TestMustExpectAllLogsAttribute(bool mustExpect = true) : Attribute
{
    public bool MustExpect { get; } = mustExpect;
}
