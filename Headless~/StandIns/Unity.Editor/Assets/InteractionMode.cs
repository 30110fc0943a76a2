namespace UnityEditor;

public enum InteractionMode
{
    AutomatedAction = 0,
    UserAction = 1,
}
