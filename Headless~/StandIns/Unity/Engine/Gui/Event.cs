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

    public bool shift
    {
        get => Has(EventModifiers.Shift);
        set => Set(EventModifiers.Shift, value);
    }

    public bool control
    {
        get => Has(EventModifiers.Control);
        set => Set(EventModifiers.Control, value);
    }

    public bool alt
    {
        get => Has(EventModifiers.Alt);
        set => Set(EventModifiers.Alt, value);
    }

    public bool command
    {
        get => Has(EventModifiers.Command);
        set => Set(EventModifiers.Command, value);
    }

    public bool isMouse { get; }
    public bool isKey { get; }
    public int clickCount { get; set; }
    public string commandName { get; set; }

    public void Use() => type = EventType.Used;

    /// <summary>Mouse events are another control's while that is hot.</summary>
    public EventType GetTypeForControl(int controlID)
    {
        bool mouse = type is EventType.MouseDown or EventType.MouseUp or EventType.MouseDrag or EventType.MouseMove;
        return mouse && GUIUtility.hotControl != 0 && GUIUtility.hotControl != controlID ? EventType.Ignore : type;
    }

    private bool Has(EventModifiers key) => (modifiers & key) != 0;

    private void Set(EventModifiers key, bool held) => modifiers = held ? modifiers | key : modifiers & ~key;
}
