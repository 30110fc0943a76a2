namespace UnityEngine;

public enum FocusType
{
    Keyboard = 1,
    Passive = 2,
}
