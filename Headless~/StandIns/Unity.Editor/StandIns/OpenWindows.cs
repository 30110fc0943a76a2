using System.Collections.Generic;
using UnityEditor;

namespace StandIns;

/// <summary>Windows that were opened; a test destroys them.</summary>
[Unity.StandIns.StandInExtension]
public static class OpenWindows
{
    public static List<EditorWindow> All { get; } = [];
}
