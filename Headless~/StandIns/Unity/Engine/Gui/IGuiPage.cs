using StandIns;

namespace UnityEngine;

/// <summary>Stand-in for a window while a test draws an inspector or a game.</summary>
internal interface IGuiPage
{
    /// <summary>The next free lines.</summary>
    Rect Next(float height);

    /// <summary>Notes a control; says whether the test presses it now.</summary>
    bool Add(ControlKind kind, Rect at, GUIContent content, string value = "");

    /// <summary>Value of a field: what the test puts there, else what it had.</summary>
    object Put(GUIContent label, object value);

    /// <summary>Number of changes that the test has made so far.</summary>
    int Changes { get; }

    /// <summary>Notes a slider; says where the test puts it.</summary>
    float Slide(Rect at, float value, float left, float right);

    /// <summary>Opens a group of controls in a place of its own.</summary>
    void BeginArea(Rect area);

    /// <summary>Opens a group.</summary>
    void Begin(string group);

    /// <summary>Closes the group that was opened last; it must be of that kind.</summary>
    void End(string group);
}

/// <summary>The page that is being drawn.</summary>
internal static class GuiPage
{
    public static IGuiPage Current { get; set; }

    public static IGuiPage Needed => Current ?? throw Absent.Gui;
}
