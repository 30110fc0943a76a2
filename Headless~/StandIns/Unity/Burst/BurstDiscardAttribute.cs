using System;

namespace Unity.Burst;

/// <summary>Burst leaves the method out; here it is called.</summary>
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Property)]
public class BurstDiscardAttribute : Attribute
{
}
