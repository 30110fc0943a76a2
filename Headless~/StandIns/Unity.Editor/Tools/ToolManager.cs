using System;

namespace UnityEditor.EditorTools;

public static class ToolManager
{
    public static event Action activeToolChanged
    {
        add { }
        remove { }
    }

    public static event Action activeContextChanged
    {
        add { }
        remove { }
    }

    public static event Action activeToolChanging
    {
        add { }
        remove { }
    }

    public static Type activeToolType { get; }
    public static Type activeContextType { get; }

    public static void SetActiveTool(Type type) => throw Absent.Editor;
    public static void SetActiveTool(EditorTool tool) => throw Absent.Editor;
    public static void SetActiveTool<T>() where T : EditorTool => throw Absent.Editor;
    public static void SetActiveContext(Type context) => throw Absent.Editor;
    public static void SetActiveContext<T>() where T : EditorToolContext => throw Absent.Editor;
    public static void RestorePreviousTool() => throw Absent.Editor;
    public static void RestorePreviousPersistentTool() => throw Absent.Editor;
    public static bool IsActiveTool(EditorTool tool) => throw Absent.Editor;
    public static bool IsActiveContext(EditorToolContext context) => throw Absent.Editor;
    public static void RefreshAvailableTools() => throw Absent.Editor;
}
