using System;

namespace Unity.Collections;

/// <summary>The job only reads the container: several jobs may read it at a time, and a write fails.</summary>
[AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter | AttributeTargets.ReturnValue)]
public sealed class ReadOnlyAttribute : Attribute
{
}
