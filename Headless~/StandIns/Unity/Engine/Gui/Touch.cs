namespace UnityEngine;

public struct Touch
{
    public Vector2 position { get; set; }
    public TouchPhase phase { get; set; }
    public int fingerId { get; set; }
}
