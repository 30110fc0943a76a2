using System;
using NUnit.Framework;

namespace UnityEngine.TestTools;

/// <summary>A routine that runs before each test, ahead of SetUp methods.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnitySetUpAttribute : NUnitAttribute;

/// <summary>A routine that runs after each test, behind TearDown methods.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTearDownAttribute : NUnitAttribute;
