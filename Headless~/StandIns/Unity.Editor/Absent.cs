using System;

namespace UnityEditor;

/// <summary>End of any call into the editor: these are signatures to compile against, not an editor.</summary>
internal static class Absent
{
    public static Exception Editor => new NotSupportedException("There is no Unity editor in the headless build.");
}
