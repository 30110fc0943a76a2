using System;

namespace Unity.Collections;

/// <summary>The job only writes the container: a read fails.</summary>
[AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter | AttributeTargets.ReturnValue)]
public sealed class WriteOnlyAttribute : Attribute
{
}
