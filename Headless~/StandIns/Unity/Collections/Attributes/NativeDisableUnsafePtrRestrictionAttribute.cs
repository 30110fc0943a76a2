using System;

namespace Unity.Collections.LowLevel.Unsafe;

/// <summary>Lets a job have a field that is a pointer.</summary>
[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute
{
}
