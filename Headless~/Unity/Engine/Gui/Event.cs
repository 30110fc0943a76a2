namespace UnityEngine;

public sealed class Event
{
    public static Event current { get; set; }
    public EventType type { get; set; }
    public EventType rawType { get; }
    public Vector2 mousePosition { get; set; }
    public Vector2 delta { get; set; }
    public int button { get; set; }
    public KeyCode keyCode { get; set; }
    public char character { get; set; }
    public EventModifiers modifiers { get; set; }
    public bool shift { get; set; }
    public bool control { get; set; }
    public bool alt { get; set; }
    public bool command { get; set; }
    public bool isMouse { get; }
    public bool isKey { get; }
    public int clickCount { get; set; }
    public string commandName { get; set; }

    public void Use() => throw Absent.Gui;
    public EventType GetTypeForControl(int controlID) => throw Absent.Gui;
}
