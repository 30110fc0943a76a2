using System;
using NUnit.Framework;

namespace UnityEngine.TestTools;

/// <summary>A routine that runs after each test of its class, and after TearDown.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTearDownAttribute : NUnitAttribute
{
}
