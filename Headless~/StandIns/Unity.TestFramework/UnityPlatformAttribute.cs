using System;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools;

/// <summary>Skips tests that are not for this platform.</summary>
[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method, AllowMultiple = true)]
public class UnityPlatformAttribute : NUnitAttribute, IApplyToTest
{
    public UnityPlatformAttribute() : this([])
    {
    }

    public UnityPlatformAttribute(params RuntimePlatform[] include)
    {
        this.include = include;
    }

    public RuntimePlatform[] include { get; set; }

    public RuntimePlatform[] exclude { get; set; } = [];

    public void ApplyToTest(Test test)
    {
        bool runs = (include.Length == 0 || include.Contains(Application.platform)) && !exclude.Contains(Application.platform);
        if (runs || test.RunState is RunState.NotRunnable or RunState.Ignored)
            return;
        test.RunState = RunState.Skipped;
        test.Properties.Add(PropertyNames.SkipReason, $"Not for {Application.platform}.");
    }
}
