using Object = UnityEngine.Object;

namespace UnityEditor.Build.Reporting;

public sealed class BuildReport : Object
{
    internal BuildReport()
    {
    }

    public BuildSummary summary { get; internal init; }
}

public struct BuildSummary
{
    public BuildResult result { get; internal init; }
    public int totalErrors { get; internal init; }
}

public enum BuildResult
{
    Unknown = 0,
    Succeeded = 1,
    Failed = 2,
    Cancelled = 3,
}
