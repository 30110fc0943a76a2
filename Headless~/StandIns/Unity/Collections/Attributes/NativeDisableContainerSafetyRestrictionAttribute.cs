using System;

namespace Unity.Collections.LowLevel.Unsafe;

/// <summary>The safety system leaves this container of the job alone.</summary>
[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableContainerSafetyRestrictionAttribute : Attribute
{
}
