namespace UnityEngine;

public class GUIContent
{
    public static GUIContent none = new();

    public GUIContent(string text) : this(text, null, null)
    {
    }

    public GUIContent(string text, string tooltip) : this(text, null, tooltip)
    {
    }

    public GUIContent(string text, Texture image) : this(text, image, null)
    {
    }

    public GUIContent(string text, Texture image, string tooltip)
    {
        this.text = text;
        this.image = image;
        this.tooltip = tooltip;
    }

    public GUIContent(Texture image) : this("", image, null)
    {
    }

    public GUIContent(Texture image, string tooltip) : this("", image, tooltip)
    {
    }

    public GUIContent(GUIContent src) : this(src.text, src.image, src.tooltip)
    {
    }

    public GUIContent()
    {
    }

    public string text { get; set; } = "";
    public Texture image { get; set; }
    public string tooltip { get; set; } = "";
}
