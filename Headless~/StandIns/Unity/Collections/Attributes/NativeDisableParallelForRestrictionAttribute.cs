using System;

namespace Unity.Collections;

/// <summary>Each index of a parallel job may write all of the container.</summary>
[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableParallelForRestrictionAttribute : Attribute
{
}
