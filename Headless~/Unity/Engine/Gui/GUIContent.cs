namespace UnityEngine;

public class GUIContent
{
    public static GUIContent none;

    public GUIContent(string text)
    {
    }

    public GUIContent(string text, string tooltip)
    {
    }

    public GUIContent(string text, Texture image)
    {
    }

    public GUIContent(string text, Texture image, string tooltip)
    {
    }

    public GUIContent(Texture image)
    {
    }

    public GUIContent(Texture image, string tooltip)
    {
    }

    public GUIContent(GUIContent src)
    {
    }

    public GUIContent()
    {
    }

    public string text { get; set; }
    public Texture image { get; set; }
    public string tooltip { get; set; }
}
