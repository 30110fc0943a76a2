using System;

namespace Unity.Burst;

/// <summary>The pointer or container shares no memory with another of the method or struct.</summary>
[AttributeUsage(AttributeTargets.Struct | AttributeTargets.Field | AttributeTargets.Parameter | AttributeTargets.ReturnValue)]
public class NoAliasAttribute : Attribute
{
}
