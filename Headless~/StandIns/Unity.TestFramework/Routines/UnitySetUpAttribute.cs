using System;
using NUnit.Framework;

namespace UnityEngine.TestTools;

/// <summary>A routine that runs before each test of its class, and before SetUp.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnitySetUpAttribute : NUnitAttribute
{
}
