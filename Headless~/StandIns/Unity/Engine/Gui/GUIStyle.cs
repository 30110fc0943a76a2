namespace UnityEngine;

public sealed class GUIStyle
{
    public GUIStyle()
    {
    }

    public GUIStyle(GUIStyle other)
    {
    }

    public static GUIStyle none { get; }
    public string name { get; set; }
    public TextAnchor alignment { get; set; }
    public FontStyle fontStyle { get; set; }
    public int fontSize { get; set; }
    public bool wordWrap { get; set; }
    public bool richText { get; set; }
    public RectOffset padding { get; set; }
    public RectOffset margin { get; set; }
    public float fixedHeight { get; set; }
    public float fixedWidth { get; set; }
    public bool stretchWidth { get; set; }
    public bool stretchHeight { get; set; }

    public Vector2 CalcSize(GUIContent content) => throw Absent.Gui;

    /// <summary>Lines of 18 pixels, in letters of 7.</summary>
    public float CalcHeight(GUIContent content, float width)
    {
        float lines = 0f;
        foreach (string line in content.text.Split('\n'))
            lines += Mathf.Max(1f, Mathf.Ceil(7f * line.Length / width));
        return 18f * lines;
    }

    public void Draw(Rect position, bool isHover, bool isActive, bool on, bool hasKeyboardFocus) => throw Absent.Gui;
    public void Draw(Rect position, string text, bool isHover, bool isActive, bool on, bool hasKeyboardFocus) => throw Absent.Gui;
    public void Draw(Rect position, GUIContent content, bool isHover, bool isActive, bool on, bool hasKeyboardFocus) => throw Absent.Gui;
    public void Draw(Rect position, Texture image, bool isHover, bool isActive, bool on, bool hasKeyboardFocus) => throw Absent.Gui;
    public static implicit operator GUIStyle(string str) => throw Absent.Gui;
}
