namespace UnityEngine;

public enum TouchPhase
{
    Began,
    Moved,
    Stationary,
    Ended,
    Canceled,
}
