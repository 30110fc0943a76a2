using System;
using UnityEditor.Build.Reporting;

namespace UnityEditor;

public class BuildPipeline
{
    public static BuildReport BuildPlayer(BuildPlayerOptions buildPlayerOptions)
    {
        int errors = StandIns.RunningEditor.BuildPlayer?.Invoke(buildPlayerOptions) ?? throw Absent.Editor;
        BuildResult result = errors == 0 ? BuildResult.Succeeded : BuildResult.Failed;
        return new BuildReport { summary = new BuildSummary { result = result, totalErrors = errors } };
    }
}

public struct BuildPlayerOptions
{
    public string[] scenes { get; set; }
    public string locationPathName { get; set; }
    public BuildTarget target { get; set; }
    public BuildOptions options { get; set; }
}

[Flags]
public enum BuildOptions
{
    None = 0,
}

public enum BuildTarget
{
    StandaloneOSX = 2,
    StandaloneWindows64 = 19,
    StandaloneLinux64 = 24,
}

public class EditorUserBuildSettings
{
    public static BuildTarget activeBuildTarget => BuildTarget.StandaloneLinux64;
}
