using Object = UnityEngine.Object;

namespace UnityEditor.Build.Reporting;

public sealed class BuildReport : Object
{
    internal BuildReport()
    {
    }

    public BuildSummary summary { get; }
}

public struct BuildSummary
{
    public BuildResult result { get; }
    public int totalErrors { get; }
}

public enum BuildResult
{
    Unknown = 0,
    Succeeded = 1,
    Failed = 2,
    Cancelled = 3,
}
