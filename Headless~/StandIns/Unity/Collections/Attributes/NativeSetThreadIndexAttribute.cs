using System;

namespace Unity.Collections.LowLevel.Unsafe;

/// <summary>An int of a job that is set to the index of the thread that executes it.</summary>
[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeSetThreadIndexAttribute : Attribute
{
}
