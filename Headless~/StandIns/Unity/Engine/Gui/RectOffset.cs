namespace UnityEngine;

public class RectOffset
{
    public RectOffset()
    {
    }

    public RectOffset(int left, int right, int top, int bottom)
    {
    }

    public int left { get; set; }
    public int right { get; set; }
    public int top { get; set; }
    public int bottom { get; set; }
    public int horizontal { get; }
    public int vertical { get; }
}
