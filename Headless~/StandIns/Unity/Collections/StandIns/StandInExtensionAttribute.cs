using System;

namespace Unity.StandIns;

/// <summary>Marks what Unity does not have: for the tests and tools of the headless build only.</summary>
[StandInExtension]
[AttributeUsage(AttributeTargets.All)]
public sealed class StandInExtensionAttribute : Attribute
{
}
